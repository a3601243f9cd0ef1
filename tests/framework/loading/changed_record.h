// Plugins with another record than the one they were built with.
#pragma once

#include <cstring>
#include <stdexcept>
#include <string>

#include <moire/plugin.h>

namespace moire::test {

// change(record) of the bytes of a plugin of this interface.
template <class Change>
void change_record(std::string& bytes, Change change) {
  const std::string_view magic(record_magic, sizeof Record::magic);
  for (auto found = bytes.find(magic); found != bytes.npos; found = bytes.find(magic, found + 1)) {
    Record record;
    std::memcpy(&record, bytes.data() + found, sizeof record);
    // The record itself, not the magic words as text, is the one that is followed by this interface version.
    if (record.interface_version != interface_version) continue;
    change(record);
    std::memcpy(bytes.data() + found, &record, sizeof record);
    return;
  }
  throw std::logic_error("these bytes are no plugin's");
}

}  // namespace moire::test
