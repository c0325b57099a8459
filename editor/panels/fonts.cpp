#include "editor/panels/fonts.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>

namespace rinceau {
namespace {

constexpr float usual_height = 15;  ///< pixels at scale 1
constexpr float built_in_height = 13;

// Latin with its accents, Greek, Cyrillic (names of files), dashes and quotes, arrows, operators, small shapes.
constexpr std::array<ImWchar, 17> letters{0x0020, 0x024f, 0x0370, 0x03ff, 0x0400, 0x04ff, 0x2010, 0x2044, 0x2070,
                                          0x209c, 0x2190, 0x21ff, 0x2200, 0x22ff, 0x25a0, 0x25ff, 0};

/// Where systems keep the DejaVu fonts.
constexpr std::array folders{"/usr/share/fonts/truetype/dejavu",
                             "/usr/share/fonts/dejavu",
                             "/usr/share/fonts/TTF",
                             "/usr/share/fonts/dejavu-sans-fonts",
                             "/usr/share/fonts/dejavu-sans-mono-fonts",
                             "/usr/local/share/fonts/dejavu",
                             "/opt/homebrew/share/fonts",
                             "/Library/Fonts"};

std::string font_file(const std::string& name) {
    for (const char* folder : folders) {
        const auto path = std::filesystem::path(folder) / name;
        std::error_code ignored;
        if (std::filesystem::is_regular_file(path, ignored)) return path.string();
    }
    return {};
}

ImFont* add_font(const std::string& name, float pixels) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFontConfig config;
    config.OversampleH = 2;
    config.PixelSnapH = true;
    const std::string file = font_file(name);
    if (!file.empty()) {
        if (ImFont* font = atlas.AddFontFromFileTTF(file.c_str(), pixels, &config, letters.data())) return font;
    }
    config.SizePixels = std::round(pixels * built_in_height / usual_height);
    return atlas.AddFontDefault(&config);
}

}  // namespace

EditorFonts load_fonts(float scale, float framebuffer) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    io.FontGlobalScale = 1 / framebuffer;
    const float pixels = std::round(usual_height * scale * framebuffer);
    return {add_font("DejaVuSans.ttf", pixels), add_font("DejaVuSansMono.ttf", pixels)};
}

}  // namespace rinceau
