import type { DeviceSnapshot, Snapshot } from '#simulation/snapshot';

import { canvasFont } from '../../../pupil/arena/model/palette';
import { piecesOf } from '../../../pupil/arena/robot/draw-trail';
import { toPx, type View } from '../../../pupil/arena/view/view-transform';
import type { Trails } from '../../../session/run/trails';
import type { RunMarks } from '../../print/run/run-painter';

/** The mark of a robot: its number and colour, and how far it reaches from its middle, in mm. */
export interface RobotMark {
  readonly number: number;
  readonly color: string;
  readonly reachMm: number;
}

/** Room between a robot and its ring, in mm. */
const AROUND_MM = 8;
const CASING = '#fff';

/**
 * The marks of the robots of a match: a ring, a number beside it, and a trail, solid for the first and dotted for the second, so
 * that nobody needs the colours. All of it grows with the picture.
 */
export function matchMarks(trails: Trails, marks: readonly RobotMark[]): RunMarks {
  const placed = (moment: Snapshot, view: View) =>
    [moment, ...moment.others].flatMap(({ robot }: DeviceSnapshot, place) => {
      const mark = marks[place];
      if (robot === null || mark === undefined) return [];
      const at = toPx(view, { x: robot.pose.xMm, y: robot.pose.yMm });
      return [{ mark, at, place, radius: (mark.reachMm * robot.scale + AROUND_MM) * view.pxPerMm }];
    });
  return {
    under(context, view, moment) {
      trails.lookAt(moment.timeUs);
      const unit = unitOf(context);
      for (const { mark, place } of placed(moment, view)) {
        const path = pathOf(piecesOf(trails.of(place), 0, view));
        context.lineJoin = context.lineCap = 'round';
        strokeWith(context, path, CASING, 4 * unit);
        context.setLineDash(mark.number === 1 ? [] : [0.1, 4.4 * unit]);
        strokeWith(context, path, mark.color, 2.2 * unit);
        context.setLineDash([]);
      }
      for (const { mark, at, radius } of placed(moment, view)) {
        const ring = new Path2D();
        ring.arc(at.x, at.y, radius, 0, 2 * Math.PI);
        strokeWith(context, ring, CASING, 4.4 * unit);
        strokeWith(context, ring, mark.color, 2.4 * unit);
      }
    },
    over(context, view, moment) {
      const unit = unitOf(context);
      const size = 11 * unit;
      context.font = `700 ${14 * unit}px ${canvasFont}`;
      context.textAlign = 'center';
      context.textBaseline = 'middle';
      for (const { mark, at, radius } of placed(moment, view)) {
        const x = Math.max(view.leftPx + size, at.x - 0.7 * radius - size / 2);
        const y = Math.max(size, at.y - 0.7 * radius - size);
        context.fillStyle = mark.color;
        context.beginPath();
        context.arc(x, y, size, 0, 2 * Math.PI);
        context.fill();
        context.fillStyle = CASING;
        context.fillText(String(mark.number), x, y + unit / 2);
      }
    },
  };
}

/** The measure of lines and letters, in px: a picture of 560 px has lines as fine as an arena's. */
const unitOf = ({ canvas }: CanvasRenderingContext2D): number =>
  Math.max(1, Math.max(canvas.width, canvas.height) / 560);

function pathOf(pieces: readonly (readonly number[])[]): Path2D {
  const path = new Path2D();
  for (const piece of pieces)
    for (let place = 0; place < piece.length; place += 2) {
      const at = [piece[place] ?? 0, piece[place + 1] ?? 0] as const;
      if (place === 0) path.moveTo(...at);
      else path.lineTo(...at);
    }
  return path;
}

function strokeWith(context: CanvasRenderingContext2D, path: Path2D, color: string, width: number): void {
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke(path);
}
