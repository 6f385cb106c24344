import { completeOptions, type OptionValues } from '#core/option';
import { filesByName, type SourceFile } from '#project/project';
import { modulesImportedBy } from '#python/imports';
import { optionsInHand } from '#robots/in-hand';
import type { RobotType } from '#robots/robot';
import type { Scene } from '#scene/scene';
import { chooseHardware, type Hardware } from '#simulation/hardware';
import { NO_ROBOT } from '#simulation/run-setup';

import { AUTO_DEVICE, AUTO_ROBOT, boardWish, firmwareOf } from '../settings/devices';
import type { Settings } from '../settings/settings';

/** The settings that a run depends on: a change of one ends the run. */
export const deviceSettings = (settings: Settings): readonly unknown[] => {
  const { device, firmware, robot, robotOptions, reality } = settings;
  return [device, firmware, robot, robotOptions, reality, seedOf(settings)];
};

/** The seed of the run. It is 1 for the ideal robot, whatever was chosen for a used one. */
export const seedOf = ({ reality, seed }: Pick<Settings, 'reality' | 'seed'>): number => (reality > 0 ? seed : 1);

/** The surroundings of a program: they decide wherever a setting says `auto`. */
export interface Surroundings {
  readonly scene: Scene;
  readonly files: readonly SourceFile[];
}

/** The settings of the hardware. */
export type HardwareSettings = Pick<Settings, 'device' | 'firmware' | 'robot' | 'robotOptions'>;

/** The robot with its options, the board and its firmware that a run would have; `null` where the course names unknown ones. */
export function hardwareOf({ scene, files }: Surroundings, settings: HardwareSettings): Hardware | null {
  const imports = modulesImportedBy(filesByName(files));
  const chosen = chooseHardware({ scene, imports, robot: settings.robot, board: boardWish(settings.device) });
  if ('problem' in chosen) return null;
  const { board, robot } = chosen;
  const changed = settings.robotOptions[robot?.id ?? NO_ROBOT];
  const options =
    robot === null ? optionsInHand(board, changed) : completeOptions(robot.options, { ...chosen.options, ...changed });
  return { board, robot, options, firmware: firmwareOf(board, settings.firmware) };
}

/** A robot's options before anything is changed by hand: as the course has them, else the defaults. */
export function startOptions(robot: RobotType, scene: Scene): OptionValues {
  return completeOptions(robot.options, scene.robot.options);
}

/**
 * The settings with another choice for a robot's option. A choice equal to the start option is not stored: it follows
 * the course.
 */
export function withOption(
  settings: HardwareSettings,
  robot: RobotType,
  scene: Scene,
  [option, choice]: readonly [string, string],
): Pick<Settings, 'robotOptions'> {
  const start = startOptions(robot, scene);
  const changed = Object.entries({ ...settings.robotOptions[robot.id], [option]: choice });
  return withOptions(settings, robot, changed.filter(([id, value]) => start[id] !== value)); // prettier-ignore
}

/** The settings without the changes to those options of a robot that the course sets: opening a course sets it up. */
export function withCourseOptions(
  settings: HardwareSettings,
  robot: RobotType,
  scene: Scene,
): Pick<Settings, 'robotOptions'> {
  const changed = Object.entries(settings.robotOptions[robot.id] ?? {});
  return withOptions(settings, robot, changed.filter(([id]) => !(id in scene.robot.options))); // prettier-ignore
}

/** The settings with exactly these changes to a robot. */
export function withOptions(
  { robotOptions }: HardwareSettings,
  robot: RobotType,
  changed: readonly (readonly [string, string])[],
): Pick<Settings, 'robotOptions'> {
  const others = Object.entries(robotOptions).filter(([id]) => id !== robot.id);
  const own = changed.length === 0 ? [] : [[robot.id, Object.fromEntries(changed)] as const];
  return { robotOptions: Object.fromEntries([...others, ...own]) };
}

/** The settings with which a program runs on this robot and on the board that it carries, changed as little as possible. */
export function settingsFor(
  robot: RobotType,
  surroundings: Surroundings,
  settings: HardwareSettings,
): Pick<Settings, 'device' | 'robot'> {
  const ways = [
    { robot: settings.robot, device: settings.device },
    { robot: AUTO_ROBOT, device: settings.device },
    { robot: settings.robot, device: AUTO_DEVICE },
    { robot: AUTO_ROBOT, device: AUTO_DEVICE },
    { robot: robot.id, device: settings.device },
    { robot: robot.id, device: AUTO_DEVICE },
  ];
  const fits = ways.find((way) => {
    const hardware = hardwareOf(surroundings, { ...settings, ...way });
    return hardware?.robot === robot && hardware.board.id === robot.board;
  });
  return fits ?? { robot: robot.id, device: robot.board };
}
