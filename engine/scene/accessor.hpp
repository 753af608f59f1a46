// Checked access to the numbers behind a glTF accessor.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "document.hpp"
#include "import_log.hpp"

namespace tyndall::scene {

/// Refuses at once whatever does not fit: views past their buffer, elements past their view, strides below the element,
/// sparse indices out of order. Reading by element then needs no check but the index's.
class AccessorReader {
 public:
  /// `what` names the accessor's use in refusals, such as "meshes[0].primitives[1].POSITION".
  AccessorReader(const document::Document& document, int accessor, std::string what);

  std::size_t count() const { return accessor_.count; }
  int width() const { return accessor_.width; }
  int componentType() const { return accessor_.componentType; }
  bool allZero() const { return !base_ && sparseAt_.empty(); }

  /// As floats: normalized integers by glTF 2.0 section 3.6.2.2 (or `normalize`, whatever the accessor says). Elements
  /// beyond the accessor's width stay as in `fallback`. Refuses what is not finite.
  glm::vec4 vector(std::size_t i, const glm::vec4& fallback = glm::vec4(0), bool normalize = false) const;
  /// Whether vector(i) has only finite components.
  bool finite(std::size_t i) const;
  /// Unsigned integers only (the caller has checked componentType).
  std::uint32_t index(std::size_t i) const { return unsignedAt(elementAt(i), accessor_.componentType); }

 private:
  static std::uint32_t unsignedAt(const unsigned char* at, int componentType);
  const unsigned char* elementAt(std::size_t i) const;
  const unsigned char* span(int view, std::size_t offset, std::size_t count, std::size_t size,
                            std::size_t& stride) const;
  void openSparse();

  const document::Document& document_;
  const document::Accessor& accessor_;
  std::string what_;
  const unsigned char* base_ = nullptr;  ///< null: zeros
  std::size_t stride_ = 0, size_ = 0;
  std::vector<std::uint32_t> sparseAt_;  ///< strictly increasing
  const unsigned char* sparseValues_ = nullptr;
};

}  // namespace tyndall::scene
