import type { RobotLook } from '../model/arena-model';
import type { RobotDrawing } from './robot-drawing';
import type { SpriteShelf } from './robot-sprite';

/** A robot type made ready to be drawn. */
export interface RobotPainting {
  readonly look: RobotLook;
  readonly drawing: RobotDrawing;
  readonly sprites: SpriteShelf;
  /** Has the picture drawn again: something that it needs has come. */
  readonly redraw: () => void;
}

/** In the hand the robot is nearer to the eye. */
export const HELD_SIZE = 1.04;
