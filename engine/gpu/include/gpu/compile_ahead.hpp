// For threads that make pipelines beside the frames.
#pragma once

namespace tyndall::gpu {

/// Lets frames go first: on a driver that runs on the CPU, they and the compiler share the cores. Call it on the thread
/// itself, before it opens a device: threads that a driver starts inherit it.
void giveWayToFrames();

/// Waits until what was compiled is in the driver's cache on disk, which it writes on a thread of its own after the
/// compiler is done.
void awaitDriverCache();

}  // namespace tyndall::gpu
