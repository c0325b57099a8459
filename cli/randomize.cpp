// rinceau randomize: a random relative of a drawing.

#include "lsystem/randomize.h"

#include "cli/edit_output.h"
#include "cli/exit_status.h"
#include "cli/verbs.h"

namespace rinceau {
namespace {

struct RandomizeVerbOptions {
    EditFiles files;
    RandomizeOptions randomize;
    bool uniform = false;
};

int run_randomize(const RandomizeVerbOptions& options) {
    const Grammar grammar = read_for_edit(options.files);
    RandomizeOptions noise = options.randomize;
    if (options.uniform)
        noise.angle_distribution = noise.distance_distribution = noise.scale_distribution = NoiseDistribution::uniform;
    if (!noise.angle && !noise.distance && !noise.scale && !noise.seed)
        throw CLI::ValidationError("randomize", "expected --angle, --distance, --scale or --seed, found none");
    write_edit(grammar, randomize(grammar, noise), options.files);
    return exit_status::done;
}

}  // namespace

void add_randomize(CLI::App& program, Job& job) {
    const auto [verb, options] = add_verb<RandomizeVerbOptions>(
        program, job, "randomize", "Make a random relative of a drawing",
        "rinceau randomize samples/fig09_helix.lsys --angle 5 --scale 0.01 --seed 3 -o wild.lsys", run_randomize);
    add_edit_options(*verb, options->files);
    RandomizeOptions& noise = options->randomize;
    verb->add_option("--angle", noise.angle, "Standard deviation of angles, in degrees; 0 takes their noise away")
        ->check(CLI::NonNegativeNumber)
        ->type_name("SD");
    verb->add_option("--distance", noise.distance, "Standard deviation of distances, as a share of each; 0 takes it away")
        ->check(CLI::NonNegativeNumber)
        ->type_name("SD");
    verb->add_option("--scale", noise.scale,
                     "Standard deviation of the logarithm of scales: 0.1 is about a tenth; 0 takes it away")
        ->check(CLI::NonNegativeNumber)
        ->type_name("SD");
    verb->add_flag("--uniform", options->uniform,
                   "Every draw up to SD to either side is as likely, and none is farther away");
    verb->add_option("--only", noise.only,
                     "Names of the numbers that get noise, as 'rinceau set' lists them; * stands for any characters")
        ->delimiter(',')
        ->type_name("NAME,..");
    verb->add_option("--seed", noise.seed, "Which of the random drawings; it is written into the grammar")->type_name("N");
}

}  // namespace rinceau
