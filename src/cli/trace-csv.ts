import { degOf, wrappedDeg } from '#core/angle';
import { rounded } from '#simulation/report';
import type { TraceRow } from '#simulation/trace';

/** The first line of a trace file; the line sensors are those of the robot in `row`, none without a robot. */
export function traceHeader(row?: TraceRow): string {
  const sensors = (row?.lineSensors ?? []).map((sensor) => `line_${sensor.name}`);
  return [
    ...['t_ms', 'x_mm', 'y_mm', 'heading_deg', 'left_mm_s', 'right_mm_s', 'left_duty', 'right_duty'],
    ...sensors,
    ...['distance_mm', 'collisions'],
  ].join(',');
}

/** One line of a trace file: three digits after the point, 1 for a bright floor, empty for no distance. */
export function traceLine(row: TraceRow): string {
  const cells = [
    row.timeUs / 1000,
    row.xMm,
    row.yMm,
    wrappedDeg(degOf(row.headingRad)),
    row.leftMmPerS,
    row.rightMmPerS,
    row.leftDuty,
    row.rightDuty,
    ...row.lineSensors.map((sensor) => (sensor.bright ? 1 : 0)),
    row.distanceMm,
    row.collisions,
  ];
  return cells.map((cell) => (cell === null ? '' : String(rounded(cell)))).join(',');
}
