import type { RobotLook } from '../model/arena-model';
import type { RobotDrawing } from './robot-drawing';
import type { SpriteShelf } from './robot-sprite';
import type { TreadShelf } from './tread-sprite';
import type { TurnedBody } from './turned-body';

/** A robot type made ready to be drawn. */
export interface RobotPainting {
  readonly look: RobotLook;
  readonly drawing: RobotDrawing;
  readonly sprites: SpriteShelf;
  readonly turned: TurnedBody;
  readonly treads: TreadShelf;
  /** Requests a redraw, once something that the picture needs has loaded. */
  readonly redraw: () => void;
}

/** Factor by which the robot looks larger in the hand. */
export const HELD_SIZE = 1.04;
