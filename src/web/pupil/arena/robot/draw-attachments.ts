import type { AttachmentState } from '#attachments/attachment';
import { attachmentTitles } from '#attachments/options';
import type { Vec } from '#core/geometry';
import type { OptionValues } from '#core/option';
import type { RobotState } from '#robots/robot';
import { arrival } from '../../../kit/state/arrival';
import { fetchedOnce } from '#core/memo';
import type * as attachmentPainterFile from './attachment-painter';
import type { RobotPainting } from './robot-painting';

/** The module that draws attachments; loaded with the first one, as most robots carry none. */
type Painter = typeof attachmentPainterFile;

const painter = arrival<Painter>();
const fetchPainter = fetchedOnce(() => import('./attachment-painter'));

/** The painter for this robot's attachments; `null` without any, or while it is loading. */
export function attachmentPainter(state: RobotState, painting: RobotPainting): Painter | null {
  if (state.attachments.length === 0) return null;
  if (painter.value === null)
    fetchPainter().then(
      (loaded) => {
        painter.set(loaded);
        painting.redraw();
      },
      () => undefined, // offline: tried again with the next picture
    );
  return painter.value;
}

/**
 * From the mount to the far edge of anything an attachment may carry, with its shadow, in mm of the real robot. Chosen
 * generously.
 */
const REACH_MM = 130;

/**
 * Distance from the robot's origin within which its attachments are painted, in mm of the real robot; 0 without any.
 */
export function attachmentReachMm(state: RobotState): number {
  return Math.max(0, ...state.attachments.map(({ atMm }) => Math.hypot(atMm.x, atMm.y) + REACH_MM));
}

/** From the mount to the front end of each attachment, in mm of the real robot: the upper edge of its drawing. */
export const LENGTH_MM: Readonly<Record<string, number>> = { claw: 64, forklift: 66, loader: 52, push: 22 };

/** Extent of the attachments ahead of the axle, in mm of the real robot; 0 without any. */
export function attachmentFrontMm(attachments: readonly AttachmentState[] = []): number {
  return Math.max(0, ...attachments.map(({ type, atMm }) => atMm.x + (LENGTH_MM[type] ?? 0)));
}

/** The attachments of a robot with these options before it runs. */
export function attachmentsAtStart(mountMm: Vec | null, options: OptionValues): readonly AttachmentState[] {
  if (mountMm === null) return [];
  return Object.entries(options)
    .filter(([, value]) => value !== 'none' && value in attachmentTitles)
    .map(([port, type]) => ({ type, port, atMm: mountMm, angleDeg: 0, turnRad: {}, heightMm: 0, isHolding: false }));
}
