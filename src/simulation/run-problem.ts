import { findBoard } from '#board/boards/index';
import { askedSensors } from '#board/sensors/asked-sensors';
import { gamepadKeys, isGamepadKey } from '#devices/gamepad';
import { isRemoteKey, remoteKeys, type RemoteKey } from '#devices/nec-remote';
import { holdsGamepad } from '#robots/in-hand';
import { robotTypes } from '#robots/index';
import { unpackLevels } from '#scene/background';
import { editProblem } from '#scene/check-edit';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { DAMAGED_BACKGROUND, runRefusal } from '#scene/run-refusal';
import type { Scene } from '#scene/scene';
import { movableIds } from './at-once';
import { fitDevices, type FittedDevice } from './fit-devices';
import type { Hardware } from './hardware';
import { reachesAll, type InputAction, type PlacedPose } from './input';
import { isMisplugged } from './robot-fit';
import { placeOfDevice } from './several/place-of-device';
import type { RunSetup } from './run-setup';

/**
 * Checks whether a set-up can run: not with an unknown robot or board, a robot inside a wall, an impossible input.
 *
 * @param isNew its inputs are given now, not recorded: then one that has no effect is a mistake, too
 * @returns one or several lines that name place and value, or the run's devices
 */
export function fitRun(
  setup: RunSetup,
  isNew = false,
): { readonly devices: readonly FittedDevice[] } | { readonly problem: string } {
  const { reality, scene } = setup;
  if (!(reality >= 0 && reality <= 1))
    return { problem: `Reality ${String(reality)} is not within 0 (ideal) … 1 (like a used school robot).` };
  const fitted = fitDevices(setup);
  if ('problem' in fitted) return fitted;
  const problem = runRefusal(scene)?.message ?? inputsProblem(setup, fitted.devices, isNew);
  return problem === null ? fitted : { problem };
}

/** A problem of the replayed log, with the place of its entry. Each is checked against the course as it is then. */
function inputsProblem(
  { scene, inputs = [] }: RunSetup,
  devices: readonly FittedDevice[],
  isNew: boolean,
): string | null {
  const targets = {
    names: devices.map(({ setup }) => setup.name),
    checks: devices.map(({ hardware }) => createInputCheck(hardware, scene, isNew)),
  };
  const inOrder = [...inputs.entries()].sort(([, a], [, b]) => a.timeUs - b.timeUs);
  let course = scene;
  let movable = movableIds(new Set(), scene, scene);
  for (const [index, { timeUs, device, action }] of inOrder) {
    const check = checkFor(targets, device);
    const found = typeof check === 'string' ? check : check(action, course, movable);
    const problem = timeUs >= 0 ? found : `${timeUs} µs lies before the start.`;
    if (problem !== null) return `[${index}]: ${problem}`;
    if (action.type !== 'edit') continue;
    course = applyEdit(course, action.edit);
    movable = movableIds(movable, scene, course);
  }
  return null;
}

/**
 * Says what is wrong with an action on a run, in words that name thing and value.
 *
 * @param course the course at that moment
 * @param movable ids of the run's movable blocks at that moment
 * @returns `null` if the action is possible
 */
export type InputCheck = (action: InputAction, course: Scene, movable: ReadonlySet<string>) => string | null;

/** The devices of a run, by place: their names, and what may be done to each. */
export interface InputTargets {
  readonly names: readonly string[];
  readonly checks: readonly InputCheck[];
}

/**
 * The check of the device of this name, or what is wrong with the name. Without a name an action that reaches all needs one
 * device for which it is possible.
 */
export function checkFor({ names, checks }: InputTargets, device: string | undefined): InputCheck | string {
  if (device === undefined && checks.length > 1) return checkOfAny(checks);
  const place = placeOfDevice(names, device);
  return typeof place === 'string' ? place : (checks[place] ?? 'This device has no board.');
}

function checkOfAny(checks: readonly InputCheck[]): InputCheck {
  return (action, course, movable) => {
    const asked = reachesAll(action) ? checks : checks.slice(0, 1);
    const problems = asked.map((check) => check(action, course, movable));
    return problems.includes(null) ? null : (problems[0] ?? null);
  };
}

/** The hardware of a device, as far as an action depends on it. */
type Plugged = Pick<Hardware, 'board' | 'robot' | 'options'>;

/**
 * Makes the check of one device of a run.
 *
 * @param began the course that the run begins with
 * @param isNew see `fitRun`
 */
export function createInputCheck({ board, robot, options }: Plugged, began: Scene, isNew = true): InputCheck {
  const sensors = askedSensors(board);
  return (action, course, movable) => {
    switch (action.type) {
      case 'button':
      case 'serial':
      case 'interrupt':
      case 'arena-senses': // without a robot there is nothing to measure: nothing happens
        return null;
      case 'radio':
        return 'bytes' in action && !action.bytes.every(isByte) ? 'radio: a packet is a list of bytes 0 … 255.' : null;
      case 'remote':
        if (!isRemoteKey(action.key)) return `remote: ${keyProblem(action.key, remoteNames)}`;
        // Recordings of before may have it.
        return isNew ? remoteProblem(action.key, { board, robot }) : null;
      case 'stick':
      case 'gamepad':
        return robot === null && holdsGamepad(options) ? gamepadProblem(action) : NO_GAMEPAD;
      case 'touch':
        return sensors.problemOf(action.pad, action.down ? 1 : 0);
      case 'sensor':
        return sensors.problemOf(action.id, action.value);
      case 'place':
        return robot !== null ? poseProblem(action.pose, began) : 'There is no robot that could be placed.';
      case 'place-block':
        return movable.has(action.id) ? poseProblem(action.pose, began) : blockProblem(action.id, movable);
      case 'no-progress':
        return began.league === undefined ? 'noProgress: the line of this course is not scored.' : null;
      case 'switch':
        return switchProblem(action.id, course);
      case 'edit':
        return editInWords(course, action.edit);
      default:
        return action satisfies never;
    }
  };
}

const remoteNames = remoteKeys.map(([name]) => name);

/** True if something of a device receives the infrared remote control. */
export const hearsRemote = ({
  board,
  robot,
}: Pick<Plugged, 'robot'> & { readonly board: { readonly id: string } }): boolean =>
  robot !== null && robot.hearsRemote !== false && robot.board === board.id;

/** The problem of a key of the remote control that nothing receives. */
function remoteProblem(key: RemoteKey, plugged: Pick<Plugged, 'board' | 'robot'>): string | null {
  if (hearsRemote(plugged)) return null;
  const { board, robot } = plugged;
  const who =
    robot === null
      ? `a ${board.name} without a robot has`
      : isMisplugged(plugged)
        ? `the ${robot.name} is on another board than its own, the ${findBoard(robot.board)?.name ?? robot.board}, and has`
        : `the ${robot.name} has`;
  const able = robotTypes.filter((type) => hearsRemote({ robot: type, board: { id: type.board } }));
  return `remote: nothing receives the key "${key}", as ${who} no infrared receiver. Robots with one: ${able.map(({ id }) => id).join(', ')}.`;
}

const NO_GAMEPAD =
  'This device has no gamepad. Give it one: --device "NAME=PROGRAM.py,robot=none,option=gamepad", with a micro:bit.';

function gamepadProblem(action: Extract<InputAction, { readonly type: 'stick' | 'gamepad' }>): string | null {
  if (action.type === 'gamepad')
    return isGamepadKey(action.key) ? null : `gamepad: ${keyProblem(action.key, gamepadKeys)}`;
  for (const side of ['x', 'y'] as const)
    if (!(Math.abs(action[side]) <= 1)) return `stick.${side}: ${action[side]} is not within -1 … 1.`;
  return null;
}

const keyProblem = (key: string, known: readonly string[]): string =>
  `there is no key "${key}". Known: ${known.join(', ')}.`;

/** The problem of an edit, in words. A damaged picture is one: else it would show only in the middle of the run. */
function editInWords(course: Scene, edit: SceneEdit): string | null {
  const problem = editProblem(course, edit);
  if (problem !== null) return `edit${problem.path === '' ? ': ' : '.'}${problem.message}`;
  const { background } = applyEdit(course, edit);
  const isNew = background !== null && background !== course.background;
  return isNew && unpackLevels(background) === null ? `edit: ${DAMAGED_BACKGROUND}` : null;
}

const isByte = (value: number): boolean => Number.isInteger(value) && value >= 0 && value <= 255;

function blockProblem(id: string, blocks: ReadonlySet<string>): string {
  const known = blocks.size > 0 ? `Known are ${[...blocks].join(', ')}.` : 'This course has none.';
  return `There is no movable block "${id}". ${known}`;
}

function switchProblem(id: string, { objects }: Scene): string | null {
  const switched = objects.filter(
    (object) =>
      (object.type === 'lamp' && object.on === 'hand') || (object.type === 'barrier' && object.opens === 'hand'),
  );
  if (switched.some((object) => object.id === id)) return null;
  const known =
    switched.length > 0 ? `Known are ${switched.map((object) => object.id).join(', ')}.` : 'This course has none.';
  return `There is no lamp or barrier "${id}" that is switched by hand. ${known}`;
}

function poseProblem({ xMm, yMm, headingDeg }: PlacedPose, { size: [width, height] }: Scene): string | null {
  if (!(xMm >= 0 && xMm <= width)) return `xMm: ${xMm} is not within 0 … ${width}, the arena.`;
  if (!(yMm >= 0 && yMm <= height)) return `yMm: ${yMm} is not within 0 … ${height}, the arena.`;
  if (!(Math.abs(headingDeg) <= 3600)) return `headingDeg: ${headingDeg} is not within -3600 … 3600.`;
  return null;
}
