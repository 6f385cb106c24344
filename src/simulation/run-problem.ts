import { Board } from '#board/board';
import { Clock } from '#core/clock';
import { placementProblems } from '#scene/placement';
import type { Scene } from '#scene/scene';
import { chooseHardware, type Hardware } from './hardware';
import type { InputAction, PlacedPose } from './input';
import type { RunSetup } from './run-setup';

/**
 * Why a set-up cannot be run: an unknown robot or board, a robot inside a wall, an input that cannot be.
 *
 * @returns one or several lines that name place and value, or the hardware of the run
 */
export function checkRun(setup: RunSetup): Hardware | { readonly problem: string } {
  const hardware = chooseHardware(setup);
  if ('problem' in hardware) return hardware;
  const problem = firstProblem(setup, hardware);
  return problem === null ? hardware : { problem };
}

function firstProblem(setup: RunSetup, { board, firmware, robot }: Hardware): string | null {
  if (!(setup.reality >= 0 && setup.reality <= 1))
    return `Reality ${String(setup.reality)} is not within 0 (ideal) … 1 (like a used school robot).`;
  const misplaced = robot ? placementProblems(setup.scene, robot.body.outlineMm) : [];
  if (misplaced.length > 0) return misplaced.map((problem) => problem.message).join('\n');
  const inputs = setup.inputs ?? [];
  const check =
    inputs.length > 0
      ? createInputCheck(new Board(board, new Clock(), firmware), setup.scene, robot !== null)
      : () => null;
  for (const [index, { timeUs, action }] of inputs.entries()) {
    const problem = timeUs >= 0 ? check(action) : `${timeUs} µs lies before the start.`;
    if (problem !== null) return `[${index}]: ${problem}`;
  }
  return null;
}

/**
 * Makes a check for what is done to a run from outside: a message that names thing and value, or `null`.
 *
 * @param rehearsal a board of the run's type, beside the run: what a sensor takes is found by setting it there
 */
export function createInputCheck(
  rehearsal: Board,
  scene: Scene,
  hasRobot: boolean,
): (action: InputAction) => string | null {
  const blocks = new Set(scene.objects.filter((object) => object.type === 'block').map((object) => object.id));
  return (action) => {
    switch (action.type) {
      case 'button':
      case 'serial':
      case 'interrupt':
      case 'arena-senses': // without a robot there is nothing to feel: nothing happens
        return null;
      case 'radio':
        return 'bytes' in action && !action.bytes.every(isByte) ? 'radio: a packet is a list of bytes 0 … 255.' : null;
      case 'touch':
        return sensorProblem(rehearsal, action.pad, action.down ? 1 : 0);
      case 'sensor':
        return sensorProblem(rehearsal, action.id, action.value);
      case 'place':
        return hasRobot ? poseProblem(action.pose, scene) : 'There is no robot that could be placed.';
      case 'place-block':
        return blocks.has(action.id) ? poseProblem(action.pose, scene) : blockProblem(action.id, blocks);
      default:
        return action satisfies never;
    }
  };
}

const isByte = (value: number): boolean => Number.isInteger(value) && value >= 0 && value <= 255;

function sensorProblem(rehearsal: Board, id: string, value: number | string): string | null {
  try {
    rehearsal.sensors.set(id, value);
    return null;
  } catch (error) {
    if (error instanceof RangeError) return error.message;
    throw error;
  }
}

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
