/**
 * Following a line as the Maqueen V5's controller does by itself (DFRobot pxt-maqueen, Maqueen_V5.patrolling). DFRobot
 * publishes only the switch and the three speeds; how it steers is chosen: the plain way for three sensors.
 */

/** Speed byte of a wheel by grade, 1 … 3: chosen. Other grades drive like the first. */
const SPEEDS = [40, 40, 55, 70] as const;

/** Share of that speed at the inner wheel while the middle sensor still sees the line, and when only an outer one does: chosen. */
const EASY = 0.55;
const SHARP = 0;

/** Whether each sensor sees the line. */
export interface LineView {
  readonly left: boolean;
  readonly middle: boolean;
  readonly right: boolean;
}

/** Speed bytes of both wheels, forward. */
export interface WheelSpeeds {
  readonly left: number;
  readonly right: number;
}

/** Something that steers along a line; it remembers on which side it saw the line last. */
export interface LineWalker {
  /**
   * What the wheels do at this sight, to be asked once per step of the world. Without a line they turn towards where it was;
   * where nobody knows, as after a sharp corner, to the left and to the right, farther each time.
   */
  next(view: LineView, grade: number): WheelSpeeds;
}

/** Steps of the world that the first search to the left takes; the one to the right takes twice as long, and so on: chosen. */
const SEARCH_STEPS = 150;

/** Makes one that has seen no line yet: until it does, it drives straight ahead. */
export function createLineWalker(): LineWalker {
  let side: 'left' | 'right' | null = null;
  let lostSteps: number | null = null; // null: no line seen yet
  return {
    next: ({ left, middle, right }, grade) => {
      const speed = SPEEDS[grade] ?? SPEEDS[0];
      const seesLine = left || middle || right;
      if (left !== right) side = left ? 'left' : 'right';
      else if (seesLine) side = null;
      if (seesLine) lostSteps = 0;
      else if (lostSteps !== null) lostSteps += 1;
      const inner = speed * (middle ? EASY : SHARP);
      const towards = seesLine || lostSteps === null ? side : (side ?? searchSide(lostSteps));
      if (towards === 'left') return { left: inner, right: speed };
      if (towards === 'right') return { left: speed, right: inner };
      return { left: speed, right: speed };
    },
  };
}

/** Where to turn so many steps after the line was lost. */
function searchSide(steps: number): 'left' | 'right' {
  let swing = 1;
  for (let rest = steps; rest >= swing * SEARCH_STEPS; swing += 1) rest -= swing * SEARCH_STEPS;
  return swing % 2 === 1 ? 'left' : 'right';
}
