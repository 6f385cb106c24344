import type { BoardType } from '#board/boards/board-type';
import { askedSensors } from '#board/sensors/asked-sensors';
import { unpackLevels } from '#scene/background';
import { editProblem } from '#scene/check-edit';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { placementProblems } from '#scene/placement';
import { DAMAGED_BACKGROUND, runRefusal } from '#scene/run-refusal';
import type { Scene } from '#scene/scene';
import { movableIds } from './at-once';
import { chooseHardware, type Hardware } from './hardware';
import type { InputAction, PlacedPose } from './input';
import type { RunSetup } from './run-setup';

/**
 * Why a set-up cannot run: an unknown robot or board, a robot inside a wall, an impossible input.
 *
 * @returns one or several lines that name place and value, or the hardware of the run
 */
export function checkRun(setup: RunSetup): Hardware | { readonly problem: string } {
  const hardware = chooseHardware({ ...setup, imports: new Set() });
  if ('problem' in hardware) return hardware;
  const problem = firstProblem(setup, hardware);
  return problem === null ? hardware : { problem };
}

function firstProblem(setup: RunSetup, { board, robot }: Hardware): string | null {
  if (!(setup.reality >= 0 && setup.reality <= 1))
    return `Reality ${String(setup.reality)} is not within 0 (ideal) … 1 (like a used school robot).`;
  const misplaced = robot ? placementProblems(setup.scene, robot.body.outlineMm) : [];
  if (misplaced.length > 0) return misplaced.map((problem) => problem.message).join('\n');
  const refusal = runRefusal(setup.scene);
  if (refusal !== null) return refusal.message;
  return inputsProblem(setup, board, robot !== null);
}

/** A problem of the replayed log, with the place of its entry. Each is checked against the course as it is then. */
function inputsProblem({ scene, inputs = [] }: RunSetup, board: BoardType, hasRobot: boolean): string | null {
  const check = createInputCheck(board, scene, hasRobot);
  const inOrder = [...inputs.entries()].sort(([, a], [, b]) => a.timeUs - b.timeUs);
  let course = scene;
  let movable = movableIds(new Set(), scene, scene);
  for (const [index, { timeUs, action }] of inOrder) {
    const problem = timeUs >= 0 ? check(action, course, movable) : `${timeUs} µs lies before the start.`;
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

/**
 * Makes the check of a run.
 *
 * @param began the course that the run begins with
 */
export function createInputCheck(board: BoardType, began: Scene, hasRobot: boolean): InputCheck {
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
      case 'touch':
        return sensors.problemOf(action.pad, action.down ? 1 : 0);
      case 'sensor':
        return sensors.problemOf(action.id, action.value);
      case 'place':
        return hasRobot ? poseProblem(action.pose, began) : 'There is no robot that could be placed.';
      case 'place-block':
        return movable.has(action.id) ? poseProblem(action.pose, began) : blockProblem(action.id, movable);
      case 'edit':
        return editInWords(course, action.edit);
      default:
        return action satisfies never;
    }
  };
}

/** Otherwise a damaged picture would show only when its levels are unpacked, in the middle of the run. */
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

function poseProblem({ xMm, yMm, headingDeg }: PlacedPose, { size: [width, height] }: Scene): string | null {
  if (!(xMm >= 0 && xMm <= width)) return `xMm: ${xMm} is not within 0 … ${width}, the arena.`;
  if (!(yMm >= 0 && yMm <= height)) return `yMm: ${yMm} is not within 0 … ${height}, the arena.`;
  if (!(Math.abs(headingDeg) <= 3600)) return `headingDeg: ${headingDeg} is not within -3600 … 3600.`;
  return null;
}
