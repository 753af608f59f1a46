// Error against time of every technique on the present view, measured in the background, one after the other.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "plot_axes.hpp"
#include "truth_reference.hpp"

namespace tyndall::editor {

class PlotPanel {
 public:
  bool open = false;
  void draw(ResearchContext& context, Reference& reference);

 private:
  struct Entry {
    std::string label;                     ///< the technique's id
    std::map<std::string, double> values;  ///< every parameter
    bool extra = false;                    ///< added by hand: stays when all are measured anew
    bool measured = false;
    std::string failure;  ///< why it could not be measured
    PlotPoint point;
  };
  void fill(ResearchContext& context);
  void measureNext(ResearchContext& context, Reference& reference);
  void chart(ResearchContext& context);
  void tooltip(const ResearchContext& context, const Entry& entry) const;
  void apply(ResearchContext& context, const Entry& entry);
  std::string changesOf(const ResearchContext& context, const Entry& entry) const;
  void tell(Workspace& workspace) const;

  std::vector<Entry> entries_;
  Shot shot_;  ///< that the entries are of, whatever their values
  JobPointer job_;
  std::uint32_t run_ = 0;  ///< grows with each list of entries: results of earlier ones are dropped
  bool measuring_ = false;
  bool referenceAsked_ = false;  ///< in this measurement
  int repeats_ = 3;
};

}  // namespace tyndall::editor
