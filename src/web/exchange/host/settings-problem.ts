import { LANGUAGES } from '#core/languages';
import { PARTS, type HostSettings, type Refusal } from '#embed/simulator';
import { robotTypes } from '#robots/index';
import { NO_ROBOT } from '#simulation/run-setup';

import { SPEEDS } from '#simulation/pace';
import { AUTO_DEVICE, AUTO_ROBOT, devices, isDevice, isRobotChoice } from '../../session/work/settings/devices';
import { isSeed, LAST_SEED, THEMES } from '../../session/work/settings/settings';

/** One sentence on the first setting whose value the app does not have; `null` when all of them can be applied. */
export function settingsProblem(wish: HostSettings): Refusal {
  const { device, robot, reality, seed } = wish;
  if (device !== undefined && !isDevice(device))
    return oneOf('device', device, [AUTO_DEVICE, ...devices.map(({ id }) => id)]);
  if (robot !== undefined && !isRobotChoice(robot))
    return oneOf('robot', robot, [AUTO_ROBOT, NO_ROBOT, ...robotTypes.map(({ id }) => id)]);
  if (reality !== undefined && !(reality >= 0 && reality <= 1))
    return `reality: ${String(reality)} is not within 0 … 1.`;
  if (seed !== undefined && !isSeed(seed)) return `seed: ${String(seed)} is no whole number within 1 … ${LAST_SEED}.`;
  return (
    choiceProblem('language', wish.language, LANGUAGES) ??
    choiceProblem('theme', wish.theme, THEMES) ??
    choiceProblem('speed', wish.speed, SPEEDS) ??
    wish.parts?.map((part) => choiceProblem('parts', part, PARTS)).find((problem) => problem !== null) ??
    null
  );
}

function choiceProblem(name: string, value: string | number | undefined, known: readonly (string | number)[]): Refusal {
  return value === undefined || known.includes(value) ? null : oneOf(name, value, known);
}

const oneOf = (name: string, value: string | number, known: readonly (string | number)[]): string =>
  `${name}: "${value}" is not one of ${known.join(', ')}.`;
