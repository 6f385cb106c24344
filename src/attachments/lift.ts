import type { Vec } from '#core/geometry';
import type { Attachment, AttachmentContext } from './attachment';
import { onRobot, shareOfWay } from './mount';

/**
 * Angles of the servo of forklift and loader: up and down. Source: informatiquecsud/mbrobot `mbtools.py` (forklift up 0°,
 * down 110°, middle 55°). For the loader no angles are public; taken to be the same.
 */
export const UP_DEG = 0;
export const DOWN_DEG = 110;

/** Highest position of the plate, in mm. Chosen: the height of the kits' block, 5 cm, less the arm's tilt. */
export const TOP_MM = 45;

/** From this height on a block no longer scrapes over the floor. Chosen: the unevenness of a school floor. */
const CLEAR_MM = 4;

/** The differences between fork and bucket, in the frame of the attachment. */
export interface LiftShape {
  /** Solid and always there: blocks are driven against it. */
  readonly backMm: readonly Vec[];
  /** The part that goes under the block. */
  readonly plateMm: readonly Vec[];
}

/** A plate that the servo raises and lowers evenly between its two angles. */
export function attachLift(context: AttachmentContext, shape: LiftShape): Attachment {
  const { chassis, scale } = context;
  const back = chassis.addPart(onRobot(context, shape.backMm));
  const fork = chassis.addFork({ plateMm: onRobot(context, shape.plateMm), clearMm: CLEAR_MM * scale });
  return {
    move: (angleDeg) => fork.setHeightMm(TOP_MM * scale * shareOfWay(angleDeg, DOWN_DEG, UP_DEG)),
    isHolding: () => fork.isHolding(),
    sonarTurnRad: () => 0,
    pose: () => ({ turnRad: {}, heightMm: fork.heightMm() / scale }),
    remove: () => {
      fork.remove();
      back.remove();
    },
  };
}
