import { freeDeviceName } from '#project/devices';
import { anyHardware, MAIN, type FurtherDevice } from '#project/project';
import { findRobot, robotTypes } from '#robots/index';
import type { Start } from '#scene/scene';
import { NO_ROBOT } from '#simulation/run-setup';
import { startsIn } from '#simulation/several/starts';

import { t } from '../../kit/i18n';
import { hardwareNow } from '../../session/work/hardware/use-hardware';
import type { WorkParts } from '../../session/work/model/parts';
import { AUTO_DEVICE } from '../../session/work/settings/devices';
import words from './words';

/** The first device's name once there are several: that of a robot as the course says. */
export const firstName = (parts: WorkParts): string =>
  hardwareNow(parts, 0)?.robot === null ? t(words.board) : (parts.work.scene.value.robot.name ?? t(words.robot));

/** The names that are taken once there is another device. */
function namesWith(parts: WorkParts): readonly string[] {
  return parts.work.hasSeveral.value ? parts.work.devices.value : [firstName(parts)];
}

/**
 * A device with the robot that the course's next start names, else one like the first device's, and the import of its
 * module.
 */
export function newRobot(parts: WorkParts): FurtherDevice {
  const start = nextStart(parts);
  const robot = findRobot(start?.robot ?? '') ?? hardwareNow(parts, 0)?.robot ?? robotTypes[0];
  const files = [{ name: MAIN, text: `from ${robot?.modules[0] ?? 'microbit'} import *\n\n` }];
  const name = freeDeviceName(start?.name || t(words.robot), namesWith(parts));
  return { ...anyHardware, name, robot: robot?.id ?? NO_ROBOT, files, sameAs: '' };
}

/** The course's start for one more robot, if it has one. */
function nextStart(parts: WorkParts): Start | undefined {
  const robots = parts.work.devices.value.filter((_, place) => (hardwareNow(parts, place)?.robot ?? null) !== null);
  return startsIn(parts.work.scene.value.objects)[robots.length - 1];
}

/** A microcomputer like the first one to hold in the hand, with its radio on. */
export function newBoard(parts: WorkParts): FurtherDevice {
  const board = hardwareNow(parts, 0)?.board;
  const chosen = parts.settings.current.value.device;
  const text = `from ${board?.modules[0] ?? 'microbit'} import *\nimport radio\n\nradio.on()\n`;
  return {
    ...anyHardware,
    name: freeDeviceName(t(words.remote), namesWith(parts)),
    device: chosen === AUTO_DEVICE ? (board?.id ?? AUTO_DEVICE) : chosen,
    robot: NO_ROBOT,
    files: [{ name: MAIN, text }],
    sameAs: '',
  };
}

/** A device like the one that is shown, which runs the same program. */
export function newTwin(parts: WorkParts): FurtherDevice {
  const { work } = parts;
  const shown = work.devices.value[work.place.value] ?? '';
  const hardware = hardwareNow(parts);
  const names = namesWith(parts);
  const { project } = work.work.value;
  const own = project.devices?.others[work.place.value - 1];
  return {
    ...anyHardware,
    ...(own && { device: own.device, firmware: own.firmware, robotOptions: own.robotOptions }),
    name: freeDeviceName(work.hasSeveral.value ? shown : firstName(parts), names),
    robot: hardware?.robot?.id ?? NO_ROBOT,
    files: [],
    sameAs:
      own?.sameAs === undefined || own.sameAs === '' ? (work.hasSeveral.value ? shown : firstName(parts)) : own.sameAs,
  };
}
