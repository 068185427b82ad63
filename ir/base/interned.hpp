// A table that gives each different value one small handle.
#pragma once

#include <cstdint>
#include <deque>
#include <unordered_map>

namespace fagorc {

/// Values by handle. Handles count from 0 in the order of first use; a value keeps its handle and its address.
template <class Id, class T, class Hash>
class Interned {
  public:
    Id intern(const T& value) {
        const auto [at, added] = ids_.try_emplace(value, static_cast<Id>(values_.size()));
        if (added) values_.push_back(value);
        return at->second;
    }
    const T& operator[](Id id) const { return values_[static_cast<std::uint32_t>(id)]; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(values_.size()); }

  private:
    std::deque<T> values_;
    std::unordered_map<T, Id, Hash> ids_;
};

}  // namespace fagorc
