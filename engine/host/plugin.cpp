// Loading and unloading plugins.
#include <algorithm>
#include <system_error>

#include "base/log.hpp"
#include "plugin_state.hpp"

namespace tyndall::host {
namespace fs = std::filesystem;
namespace {

void tell(std::uint32_t level, const std::string& line) {
  if (level >= TY_LOG_ERROR)
    log::error(line);
  else if (level == TY_LOG_WARNING)
    log::warning(line);
  else if (level == TY_LOG_INFO)
    log::info(line);
  else
    log::debug(line);
}

void logLine(void* context, std::uint32_t level, const char* line) {
  const auto text = readText(line, "a log line");
  static_cast<PluginLog*>(context)->line(level, text ? *text : "gave a log line that is null or too long");
}

const void* noExtension(void*, const char*) { return nullptr; }

}  // namespace

void PluginLog::line(std::uint32_t level, const std::string& text) {
  {
    const std::lock_guard lock(mutex_);
    if (holding_ && level >= TY_LOG_WARNING) {
      held_.push_back({level, text});
      PluginCall::heard(text);
      return;
    }
  }
  tell(level, prefix + text);
}

void PluginLog::hold() {
  const std::lock_guard lock(mutex_);
  holding_ = true;
}

void PluginLog::letGo() {
  std::vector<Line> lines;
  {
    const std::lock_guard lock(mutex_);
    holding_ = false;
    lines.swap(held_);
  }
  for (const Line& line : lines) tell(line.level, prefix + line.text);
}

std::string PluginLog::reason() {
  const std::lock_guard lock(mutex_);
  holding_ = false;
  std::string text;
  for (const Line& line : std::exchange(held_, {})) text += (text.empty() ? ": " : "; ") + line.text;
  return text.empty() ? " and gave no reason; a line by its host's log() would" : text;
}

Plugin::State::~State() {
  if (instance != nullptr) destroy(instance);
  if (!initialised) return;
  const PluginCall call(called(), "shutdown()");
  plugin.shutdown();
}

TyInstance* Plugin::State::create() {
  const PluginCall call(called(), "create()");
  return plugin.create();
}

void Plugin::State::destroy(TyInstance* made) {
  const PluginCall call(called(), "destroy()");
  plugin.destroy(made);
}

Result<std::unique_ptr<Plugin>> Plugin::load(const fs::path& path) {
  auto library = Library::open(path);
  if (!library) return library.error();
  const auto refuse = [&](const std::string& why) { return failed(path.string() + ": " + why); };

  auto state = std::make_unique<State>();
  state->path = path;
  state->library = library.take();
  const void* entry = state->library->symbol(TY_ENTRY_SYMBOL);
  if (entry == nullptr) return refuse("has no symbol '" TY_ENTRY_SYMBOL "'; a plugin exports one");
  auto read = readPlugin(entry);
  if (!read) return refuse(read.error().message);
  state->plugin = *read;
  state->id = state->plugin.id;
  state->name = *readText(state->plugin.name, "name");
  state->version = *readText(state->plugin.version, "version");
  state->doc = *readText(state->plugin.doc, "doc");
  state->log.prefix = state->id + ": ";

  state->host.struct_size = sizeof(TyHost);
  state->host.abi_version = TY_ABI_VERSION;
  state->host.name = "tyndall " TYNDALL_VERSION;
  state->host.context = &state->log;
  state->host.log = logLine;
  state->host.get_extension = noExtension;
  state->log.hold();
  {
    const PluginCall call(state->called(), "init()");
    state->initialised = state->plugin.init(&state->host);
  }
  if (!state->initialised) return refuse("the plugin refused to start: its init failed" + state->log.reason());
  state->log.letGo();

  auto tables = [&] {
    const PluginCall call(state->called(), "parameters() or techniques()");
    return readTables(state->plugin);
  }();
  if (!tables) return refuse(tables.error().message);
  state->tables = tables.take();
  state->log.hold();
  state->instance = state->create();
  if (state->instance == nullptr)
    return refuse("the plugin could not be set up: its create failed" + state->log.reason());
  state->log.letGo();

  std::unique_ptr<Plugin> plugin(new Plugin);
  plugin->state_ = std::move(state);
  return plugin;
}

Plugin::~Plugin() = default;
const std::string& Plugin::id() const { return state_->id; }
const std::string& Plugin::name() const { return state_->name; }
const std::string& Plugin::version() const { return state_->version; }
const std::string& Plugin::doc() const { return state_->doc; }
const fs::path& Plugin::path() const { return state_->path; }
const std::vector<params::Parameter>& Plugin::parameters() const { return state_->tables.parameters; }
const std::vector<TechniqueInfo>& Plugin::techniques() const { return state_->tables.techniques; }
std::uint32_t Plugin::selector() const { return state_->tables.selector; }

bool Plugin::fileChanged() const {
  if (state_->library->inPlace()) return false;  // it could not be reloaded
  const auto now = fileIdentity(state_->path);
  return now && *now != state_->library->identity();  // a missing file is one that is being rebuilt
}

PluginSet loadPlugins(const fs::path& folder) {
  PluginSet set;
  std::vector<fs::path> files;
  std::error_code code;
  for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code))
    if (it->path().extension() == ".so") files.push_back(it->path());
  if (code) {
    set.errors.push_back(failed(folder.string() + ": plugins cannot be looked for: " + code.message()));
    return set;
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    auto plugin = Plugin::load(file);
    if (!plugin) {
      set.errors.push_back(plugin.error());
      continue;
    }
    const std::string& id = (*plugin)->id();
    const auto same =
        std::find_if(set.plugins.begin(), set.plugins.end(), [&](const auto& other) { return other->id() == id; });
    if (same != set.plugins.end())
      set.errors.push_back(failed(file.string() + ": its id '" + id + "' is already that of " +
                                  (*same)->path().string() + "; ids are unique"));
    else
      set.plugins.push_back(plugin.take());
  }
  return set;
}

}  // namespace tyndall::host
