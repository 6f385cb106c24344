import type { RobotState } from '#robots/robot';
import { memoOf } from '#core/memo';
import type { RobotPainting } from './robot-painting';
import { createSpriteShelf, type RobotSprite, type SpriteShelf } from './robot-sprite';

/** Travel of a pressed half, in mm. Chosen: twice the travel of a microswitch, to be visible. */
const PRESSED_MM = 3;

/** A pressed half is tinted: at a small zoom 3 mm are hardly a pixel. */
const PRESSED_TINT = 'rgba(255, 74, 61, 0.72)';

/** Both halves of a bumper, each at rest and pressed. */
interface Bumper {
  readonly left: Half;
  readonly right: Half;
}
interface Half {
  readonly resting: SpriteShelf;
  readonly pressed: SpriteShelf;
}

/** Made when a robot first carries its bumper. */
const bumperOf = memoOf((painting: RobotPainting): Bumper | null => {
  const { bumper, viewBox } = painting.drawing;
  if (bumper === null) return null;
  const halfOf = (svg: string): Half => ({
    resting: createSpriteShelf({ svg, viewBox }, painting.redraw),
    pressed: createSpriteShelf({ svg, viewBox }, painting.redraw, PRESSED_TINT),
  });
  return { left: halfOf(bumper.left), right: halfOf(bumper.right) };
});

/** A half of the bumper in its current state. */
export interface BumperSprite {
  readonly sprite: RobotSprite;
  /** Travel of the half towards the axle, in drawing units (mm). */
  readonly pushedMm: number;
}

/** The halves of the bumper that the robot carries now, at this many canvas pixels per mm; empty without a bumper. */
export function bumperSprites(painting: RobotPainting, state: RobotState, pixelsPerMm: number): BumperSprite[] {
  const bumper = state.bumper === null ? null : bumperOf(painting);
  if (bumper === null) return [];
  return (['left', 'right'] as const).flatMap((side) => {
    const isPressed = state.bumper?.[side] === true;
    const sprite = bumper[side][isPressed ? 'pressed' : 'resting'].at(pixelsPerMm);
    return sprite === null ? [] : [{ sprite, pushedMm: isPressed ? PRESSED_MM : 0 }];
  });
}
