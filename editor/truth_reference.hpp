// The reference of the present view, made in the background: coarse first, then in full, and how far the present
// settings are from it.
#pragma once

#include <optional>
#include <string>

#include "image/metrics.hpp"
#include "research_context.hpp"

namespace tyndall::editor {

enum class ReferenceKind { kTraced, kMarched, kStored };

/// A picture of in-scattered radiance and what it is of.
struct ScatterPicture {
  Shot shot;
  image::FloatImage scatter;
};

class Reference {
 public:
  // What is wanted; the panel's fields.
  ReferenceKind kind = ReferenceKind::kTraced;
  int samples = 256;   ///< shadow rays per view ray and light of the traced one
  bool again = false;  ///< starts anew whenever the view has changed

  /// Starts the coarse one for the present view; what was running is cancelled.
  void start(ResearchContext& context);
  void cancel();
  /// Once a frame: goes on to the next size, follows changed settings with the picture that is compared.
  void update(ResearchContext& context);
  void store() { stored_ = current_; }  ///< keeps the present picture for comparing

  /// Of what is compared now: both of one size. Null until there are both.
  const ScatterPicture* picture() const { return comparable() ? &*current_ : nullptr; }
  const ScatterPicture* truth() const { return comparable() ? source() : nullptr; }
  /// What there is to compare with, whether something is compared with it or not; null: nothing.
  const ScatterPicture* source() const;
  /// Of picture() against truth(); empty whenever these are null.
  const std::optional<image::ErrorMetrics>& metrics() const;
  double effectMs() const { return effectMs_; }
  std::uint32_t version() const { return version_; }  ///< grows whenever one of the pictures is another
  bool valid(const ResearchContext& context) const;   ///< the reference is of the present view
  bool full(const ResearchContext& context) const {
    return valid(context) && source()->shot.width == context.shot.width && source()->shot.height == context.shot.height;
  }
  /// What is compared is a picture of the present settings.
  bool upToDate(const ResearchContext& context) const {
    return current_ && current_->shot == context.shot.scaledTo(current_->shot.width, current_->shot.height);
  }
  const JobPointer& job() const { return job_; }
  bool active() const { return running(job_) || next_ > 0; }
  bool hasStored() const { return stored_.has_value(); }

 private:
  bool comparable() const;
  void startSize(ResearchContext& context, std::uint32_t divisor);
  void renderCurrent(ResearchContext& context);
  void compare(Workspace& workspace);

  std::optional<ScatterPicture> made_, stored_, current_;
  std::optional<Shot> wanted_;  ///< that the reference in the making is of, at full size
  ReferenceKind madeKind_ = ReferenceKind::kTraced, seenKind_ = ReferenceKind::kTraced;
  std::uint32_t next_ = 0;  ///< divisor of the size to be made next; 0: none
  JobPointer job_, currentJob_;
  std::optional<Shot> currentShot_;  ///< that currentJob_ is for, or was
  std::optional<image::ErrorMetrics> metrics_;
  double effectMs_ = 0;
  std::uint32_t version_ = 0;
};

}  // namespace tyndall::editor
