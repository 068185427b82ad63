// Live values from the command line: --set NAME=VALUE.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ir/control/dialect.hpp"
#include "ir/diag/diagnostic.hpp"
#include "ir/program/live.hpp"

namespace fagorc::tool {

class SetValues final : public program::LiveValues {
  public:
    /// Reads the options; false for one that is no NAME=NUMBER (reported). Names count in upper case, without blanks.
    bool read(const std::vector<std::string>& options, const control::Dialect& dialect, diag::Sink& out);
    std::optional<double> value(std::string_view name) override;

  private:
    std::map<std::string, double, std::less<>> values_;
};

}  // namespace fagorc::tool
