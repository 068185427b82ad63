// Finds loops that can never end: a backward jump that is taken again while nothing that a decision could depend on has
// changed since.
#pragma once

#include <cstdint>

#include "ir/diag/diagnostic.hpp"

namespace fagorc::passes {

class LoopWatch {
  public:
    /// Tells of a jump and of the number of changes to parameters, variables and calls so far. True when the same jump
    /// was taken before with the same number. Remembers one jump, and a later one after 1, 2, 4 ... jumps, so that the
    /// way into a loop does not hide it (Brent).
    bool endless(diag::FileId file, std::uint64_t offset, std::uint64_t changes) {
        if (changes == changes_) {
            if (file == file_ && offset == offset_) return true;
            if (++jumps_ < limit_) return false;
            limit_ *= 2;
        } else {
            limit_ = 1;
        }
        file_ = file;
        offset_ = offset;
        changes_ = changes;
        jumps_ = 0;
        return false;
    }

  private:
    diag::FileId file_ = diag::FileId::none;
    std::uint64_t offset_ = 0, changes_ = 0, jumps_ = 0, limit_ = 1;
};

}  // namespace fagorc::passes
