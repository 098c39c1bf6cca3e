#include <rviz_plugins/panel/review_panel.h>

#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include <pluginlib/class_list_macros.hpp>
#include <rviz/visualization_manager.h>

#include <cable_variation/GetScene.h>
#include <cable_variation/LoadScene.h>
#include <cable_variation/SaveScene.h>

#include <rviz_plugins/panel/analyses_tab.h>
#include <rviz_plugins/panel/camera_start.h>
#include <rviz_plugins/panel/design_tab.h>
#include <rviz_plugins/panel/message_line.h>
#include <rviz_plugins/panel/motion_bar.h>
#include <rviz_plugins/panel/save_dialog.h>
#include <rviz_plugins/panel/solver_connection.h>

namespace cable_variation_rviz {

namespace {

// What messages are of.
constexpr char kLoad[] = "load", kSave[] = "save";

}  // namespace

ReviewPanel::ReviewPanel(QWidget* parent)
    : rviz::Panel(parent),
      scene_(new QLabel),
      load_(new QPushButton(QString::fromUtf8("Load\u2026"))),
      save_(new QPushButton(QString::fromUtf8("Save\u2026"))),
      tabs_(new QTabWidget),
      motion_place_(new QVBoxLayout),
      message_(new MessageLine) {
  scene_->setObjectName("scene");
  tabs_->setObjectName("tabs");
  load_->setObjectName("load");
  load_->setToolTip("Another scene, in all nodes");
  connect(load_, &QPushButton::clicked, this, &ReviewPanel::chooseScene);
  save_->setObjectName("save");
  save_->setToolTip("The design as a scene file of its own");
  save_->setEnabled(false);
  connect(save_, &QPushButton::clicked, this, &ReviewPanel::chooseName);
  scene_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* top = new QHBoxLayout;
  top->addWidget(scene_, 1);
  top->addWidget(load_);
  top->addWidget(save_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addLayout(top);
  layout->addWidget(tabs_, 1);
  layout->addLayout(motion_place_);
  layout->addWidget(message_);
}

ReviewPanel::~ReviewPanel() { disconnectAll(); }

void ReviewPanel::disconnectAll() {
  states_.shutdown();
  while (tabs_->count() > 0) delete tabs_->widget(0);  // they use the connection
  delete motion_;
  motion_ = nullptr;
  delete camera_;
  camera_ = nullptr;
  solver_.reset();
}

void ReviewPanel::onInitialize() {
  takePlace();
  connectTo(solver_name_, player_name_);
}

// On the right, where there is nothing yet. A place saved with the configuration is restored after this.
void ReviewPanel::takePlace() {
  auto* dock = qobject_cast<QDockWidget*>(parentWidget());
  auto* window = qobject_cast<QMainWindow*>(this->window());
  if (dock != nullptr && window != nullptr && !dock->isFloating()) {
    window->addDockWidget(Qt::RightDockWidgetArea, dock);
  }
}

void ReviewPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString solver = QString::fromStdString(solver_name_), player = QString::fromStdString(player_name_);
  config.mapGetString("Solver", &solver);
  config.mapGetString("Motion Player", &player);
  if (solver.toStdString() != solver_name_ || player.toStdString() != player_name_) {
    connectTo(solver.toStdString(), player.toStdString());
  }
}

void ReviewPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Solver", QString::fromStdString(solver_name_));
  config.mapSetValue("Motion Player", QString::fromStdString(player_name_));
}

void ReviewPanel::connectTo(const std::string& solver, const std::string& player) {
  disconnectAll();
  solver_name_ = solver;
  player_name_ = player;
  solver_ = std::make_unique<SolverConnection>(solver);
  state_.reset();
  scene_->setText("waiting for " + QString::fromStdString(solver));

  design_ = new DesignTab(*solver_);
  tabs_->addTab(design_, "Design");
  connect(design_, &DesignTab::failed, message_, &MessageLine::showError);
  connect(design_, &DesignTab::succeeded, message_, &MessageLine::clear);
  analyses_ = new AnalysesTab(*solver_);
  tabs_->addTab(analyses_, "Analyses");
  connect(analyses_, &AnalysesTab::failed, message_, &MessageLine::showError);
  connect(analyses_, &AnalysesTab::succeeded, message_, &MessageLine::clear);
  connect(analyses_, &AnalysesTab::variableChosen, design_, &DesignTab::showEffect);
  camera_ = new CameraStart(*solver_, *vis_manager_, this);
  motion_ = new MotionBar(*solver_, player);
  motion_place_->addWidget(motion_);
  connect(motion_, &MotionBar::failed, message_, &MessageLine::showError);
  connect(motion_, &MotionBar::succeeded, message_, &MessageLine::clear);
  states_ = solver_->hear<cable_variation::DesignState>(
      solver + "/design", [this](const cable_variation::DesignStateConstPtr& state) { follow(state); });
}

void ReviewPanel::follow(const cable_variation::DesignStateConstPtr& state) {
  const bool other = !state_ || state_->source != state->source || state_->loads != state->loads;
  state_ = state;
  save_->setEnabled(true);
  const QFileInfo file(QString::fromStdString(state->source));
  scene_->setText("<b>" + file.fileName().toHtmlEscaped() + "</b>" + (state->edited ? ", edited" : ""));
  scene_->setToolTip(file.absoluteFilePath());
  if (other) {
    takeScene();
  } else {
    design_->setState(*state);
  }
}

void ReviewPanel::chooseScene() {
  const QString folder =
      state_ ? QFileInfo(QString::fromStdString(state_->source)).absolutePath() : QString();
  const QString file =
      QFileDialog::getOpenFileName(this, "Load scene", folder, "Scenes (*.yaml *.yml);;All files (*)");
  if (file.isEmpty()) return;
  cable_variation::LoadSceneRequest request;
  request.scene = file.toStdString();
  message_->showNote(kLoad, "loading " + file);
  solver_->ask<cable_variation::LoadScene>(
      solver_name_ + "/load_scene", request, "load",
      [this](const cable_variation::LoadSceneResponse&, const std::string& failure) {
        if (failure.empty()) {
          message_->clearAll();
        } else {
          message_->showError(kLoad, QString::fromStdString(failure));
        }
      });
}

void ReviewPanel::chooseName() {
  const QString file =
      state_ ? QFileInfo(QString::fromStdString(state_->source)).completeBaseName() : "scene";
  auto* dialog = new SaveDialog(file + "_edited", this);
  connect(dialog, &SaveDialog::chosen, this, &ReviewPanel::saveScene);
  dialog->open();
}

void ReviewPanel::saveScene(const QString& name, bool overwrite) {
  cable_variation::SaveSceneRequest request;
  request.name = name.toStdString();
  request.overwrite = overwrite;
  solver_->ask<cable_variation::SaveScene>(
      solver_name_ + "/save_scene", request, "",
      [this](const cable_variation::SaveSceneResponse& answer, const std::string& failure) {
        if (!failure.empty()) {
          message_->showError(kSave, QString::fromStdString(failure));
          return;
        }
        QStringList lines{"saved as " + QString::fromStdString(answer.file)};
        for (const std::string& warning : answer.warnings) lines << QString::fromStdString(warning);
        message_->showNote(kSave, lines.join('\n'));
      });
}

void ReviewPanel::takeScene() {
  solver_->ask<cable_variation::GetScene>(
      solver_name_ + "/get_scene", {}, "scene",
      [this](const cable_variation::GetSceneResponse& scene, const std::string& failure) {
        if (!failure.empty()) {
          message_->showError(kLoad, QString::fromStdString(failure));
          return;
        }
        message_->clear(kLoad);
        camera_->sceneChanged();
        design_->setScene(scene);
        analyses_->setScene(scene);
        if (state_) design_->setState(*state_);
      });
}

}  // namespace cable_variation_rviz

PLUGINLIB_EXPORT_CLASS(cable_variation_rviz::ReviewPanel, rviz::Panel)
