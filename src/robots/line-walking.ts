/**
 * Following a line as controllers of DFRobot do by themselves (pxt-maqueen, Maqueen_V5.patrolling; the Maqueen Plus V3's
 * patrol). DFRobot publishes only the switch and the number of speeds; the steering is chosen: the simple rule for three
 * sensors.
 */

/** Share of that speed at the inner wheel if the middle sensor sees the line, and if only an outer one does: chosen. */
const EASY = 0.55;
const SHARP = 0;

/** For each sensor: true if it sees the line. */
export interface LineView {
  readonly left: boolean;
  readonly middle: boolean;
  readonly right: boolean;
}

/** Speeds of both wheels, forward, in the unit of the speed that was given. */
export interface WheelSpeeds {
  readonly left: number;
  readonly right: number;
}

/** Steers along a line; remembers on which side it last saw the line. */
export interface LineWalker {
  /**
   * The wheels' speeds for this sight; call it once per step of the world. Without a line they turn towards its last
   * side. If that is unknown, as after a sharp corner, they turn to the left and to the right, farther each time.
   */
  next(view: LineView, speed: number): WheelSpeeds;
}

/**
 * Duration of the first search (to the left) in steps of the world; the next takes twice as long, and so on: chosen.
 */
const SEARCH_STEPS = 150;

/** Makes one that has not seen a line yet: until it does, it drives straight ahead. */
export function createLineWalker(): LineWalker {
  let side: 'left' | 'right' | null = null;
  let lostSteps: number | null = null; // null: no line seen yet
  return {
    next: ({ left, middle, right }, speed) => {
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

/** The direction to turn this many steps after the line was lost. */
function searchSide(steps: number): 'left' | 'right' {
  let swing = 1;
  for (let rest = steps; rest >= swing * SEARCH_STEPS; swing += 1) rest -= swing * SEARCH_STEPS;
  return swing % 2 === 1 ? 'left' : 'right';
}
