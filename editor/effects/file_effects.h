#pragma once
// Files, folders, copies for emergencies and preferences: what of requests concerns the disk.

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "editor/effects/action_queue.h"
#include "editor/effects/errands.h"
#include "editor/effects/held_lock.h"
#include "editor/effects/recovery_files.h"
#include "editor/effects/worker.h"
#include "editor/model/request.h"

namespace rinceau {

/// Where the program keeps what is its own; empty = it keeps nothing there.
struct KeptFolders {
    std::string state;
    std::string config;
};

/// Everything is done on threads, writing in the order in which it was asked for; the destructor waits for what is to be
/// written. Answers come through the queue. Never throws.
class FileEffects {
  public:
    FileEffects(ActionQueue& answers, KeptFolders folders);

    void fulfil(const ReadDocument& request);
    void fulfil(const WriteDocument& request);
    void fulfil(const WriteExport& request);
    void fulfil(const StopExport& request);
    void fulfil(const HoldFile& request);
    void fulfil(const ListFolder& request);
    void fulfil(const MakeFolder& request);
    void fulfil(const LookAtPath& request);
    void fulfil(const ListSamples& request);
    void fulfil(const WriteRecovery& request);
    void fulfil(const RemoveRecovery& request);
    void fulfil(const FindRecoverables& request);
    void fulfil(const ReadRecovery& request);
    void fulfil(const DiscardRecovery& request);
    void fulfil(const WritePreferences& request);

  private:
    void answer_folder(const std::function<FolderListed()>& list);
    void hold(const std::string& path);

    ActionQueue& answers_;
    KeptFolders folders_;
    std::shared_ptr<std::atomic<bool>> export_stopped_;  ///< of the last export
    // Used by the thread of writes_ alone.
    RecoveryFiles recovery_;
    std::string held_path_;
    std::optional<HeldLock> held_;
    Errands reads_;
    Errands looks_;   ///< at folders
    Errands writes_;  ///< last: waits for what is to be written while all else is still there
};

}  // namespace rinceau
