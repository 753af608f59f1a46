#include "truth_reference.hpp"

#include <algorithm>

namespace tyndall::editor {
namespace {

constexpr std::uint32_t kCoarseDivisor = 4;     // the first picture has a sixteenth of the pixels
constexpr std::uint32_t kLeastCoarseSide = 32;  // below this the full one is as quick

}  // namespace

const ScatterPicture* Reference::source() const {
  if (kind == ReferenceKind::kStored) return stored_ ? &*stored_ : nullptr;
  return made_ && madeKind_ == kind ? &*made_ : nullptr;
}

bool Reference::comparable() const {
  const ScatterPicture* truth = source();
  return truth && current_ && current_->scatter.width == truth->scatter.width &&
         current_->scatter.height == truth->scatter.height;
}

const std::optional<image::ErrorMetrics>& Reference::metrics() const {
  static const std::optional<image::ErrorMetrics> none;
  return comparable() ? metrics_ : none;
}

bool Reference::valid(const ResearchContext& context) const {
  const ScatterPicture* truth = source();
  return truth && truth->shot.sameTruth(context.shot.scaledTo(truth->shot.width, truth->shot.height));
}

void Reference::start(ResearchContext& context) {
  cancel();
  if (kind == ReferenceKind::kStored) return;
  wanted_ = context.shot;
  madeKind_ = kind;
  made_.reset();
  metrics_.reset();  // figures without their reference mean nothing
  ++version_;
  const bool coarse = std::min(wanted_->width, wanted_->height) / kCoarseDivisor >= kLeastCoarseSide;
  startSize(context, coarse ? kCoarseDivisor : 1);
}

void Reference::cancel() {
  if (job_) job_->cancel();
  next_ = 0;
}

void Reference::startSize(ResearchContext& context, std::uint32_t divisor) {
  next_ = 0;
  Laboratory* laboratory = context.laboratory();
  if (!laboratory) return;
  const Shot shot = wanted_->scaledTo(std::max(wanted_->width / divisor, 1u), std::max(wanted_->height / divisor, 1u));
  Workspace* workspace = &context.workspace;
  const auto done = [this, shot, divisor, workspace](Result<image::FloatImage> picture) {
    if (!picture) return workspace->tell(picture.error().message, true);
    made_ = ScatterPicture{shot, picture.take()};
    ++version_;
    if (divisor > 1) next_ = 1;
    compare(*workspace);
  };
  const std::string size = std::to_string(shot.width) + " x " + std::to_string(shot.height);
  if (kind == ReferenceKind::kTraced) {
    job_ = laboratory->truth("tracing rays, " + size, {shot, static_cast<std::uint32_t>(samples)}, done);
    return;
  }
  // Whatever the technique is, the march goes through every light's shadow map; the default technique knows them all.
  RenderTask task;
  task.shot = shot;
  task.reference = true;
  const host::Plugin& plugin = context.session.catalogue().effectPlugin();
  for (const params::Parameter& parameter : context.session.table().parameters()) {
    const bool selector =
        plugin.selector() < plugin.parameters().size() && parameter.id == plugin.parameters()[plugin.selector()].id;
    if (selector || parameter.id == plugin.id() + ".enabled") task.shot.values[parameter.id] = parameter.defaultValue;
  }
  job_ = laboratory->render("dense march, " + size, task, [done](Result<RenderResult> result) {
    if (!result) return done(result.error());
    done(std::move(result->scatter));
  });
}

void Reference::update(ResearchContext& context) {
  if (seenKind_ != kind) {
    // A reference of another kind in the making is no longer wanted.
    if (kind != madeKind_) cancel();
    seenKind_ = kind;
    ++version_;
    compare(context.workspace);
  }
  const bool moved = wanted_ && !wanted_->sameTruth(context.shot);
  if (moved && active()) cancel();
  // The coarse comparison is shown before the next size is begun.
  if (next_ > 0 && !running(job_) && context.settled) {
    renderCurrent(context);
    startSize(context, next_);
  }
  if (again && context.settled && !active() && kind != ReferenceKind::kStored && (!wanted_ || moved)) start(context);
  if (context.settled) renderCurrent(context);
}

/// The present settings at the reference's size.
void Reference::renderCurrent(ResearchContext& context) {
  const ScatterPicture* truth = source();
  // Without a reference the present picture is kept all the same: it may be stored.
  const Shot shot = truth ? context.shot.scaledTo(truth->shot.width, truth->shot.height) : context.shot;
  if (truth && kind != ReferenceKind::kStored && !valid(context)) return;  // it would be compared with another view's
  if (currentShot_ && *currentShot_ == shot) return;
  if (running(currentJob_)) currentJob_->cancel();
  Laboratory* laboratory = context.laboratory();
  if (!laboratory) return;
  currentShot_ = shot;
  Workspace* workspace = &context.workspace;
  currentJob_ = laboratory->render("picture to compare", {shot, {}, false, 1},
                                   [this, shot, workspace](Result<RenderResult> result) {
                                     if (!result) return workspace->tell(result.error().message, true);
                                     current_ = ScatterPicture{shot, std::move(result->scatter)};
                                     effectMs_ = result->effectMs;
                                     ++version_;
                                     compare(*workspace);
                                   });
}

void Reference::compare(Workspace& workspace) {
  metrics_.reset();
  if (!comparable()) return;
  auto metrics = image::compare(current_->scatter, source()->scatter);
  if (!metrics) return workspace.tell("comparison: " + metrics.error().message, true);
  metrics_ = *metrics;
}

}  // namespace tyndall::editor
