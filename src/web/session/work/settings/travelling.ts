import { defaultProjectSettings, type ProjectSettings } from '#project/project';

import { settingsFromText, type Settings } from './settings';

/** The settings that travel with a project: what its run depends on. */
export function travelling(settings: Settings): ProjectSettings {
  const { device, firmware, robot, robotOptions, reality, seed, arenaSenses, myRobot } = settings;
  const chosen = { device, firmware, robot, robotOptions, reality, seed, arenaSenses };
  return myRobot === null ? chosen : { ...chosen, myRobot };
}

/** The settings with those of a project; where it names something this app does not have, the default. */
export function withTravelling(settings: Settings, brought: ProjectSettings): Settings {
  const { device, firmware, robot, robotOptions, reality, seed, arenaSenses, myRobot } = brought;
  const chosen = { device, firmware, robot, robotOptions, reality, seed, arenaSenses, myRobot: myRobot ?? null };
  const text = JSON.stringify({ ...settings, ...chosen });
  return settingsFromText(text, { ...settings, ...defaultProjectSettings });
}
