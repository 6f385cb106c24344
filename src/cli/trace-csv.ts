import { degOf, wrappedDeg } from '#core/angle';
import { rounded } from '#simulation/report';
import type { TraceRow } from '#simulation/trace';

/** The columns of a trace file that depend on the run. */
export interface TraceColumns {
  /** Names of the line sensors of all robots. */
  readonly sensors: readonly string[];
  /** True if each line names its device. */
  readonly device: boolean;
}

/** The columns for the robots of these rows; `device` only where there are several devices. */
export function traceColumns(rows: readonly TraceRow[], devices: number): TraceColumns {
  const names = rows.flatMap(({ lineSensors }) => lineSensors.map(({ name }) => name));
  return { sensors: [...new Set(names)], device: devices > 1 };
}

/** The first line of a trace file. */
export function traceHeader({ sensors, device }: TraceColumns): string {
  return [
    ...['t_ms', 'x_mm', 'y_mm', 'heading_deg', 'left_mm_s', 'right_mm_s', 'left_duty', 'right_duty'],
    ...sensors.map((name) => `line_${name}`),
    ...['distance_mm', 'collisions'],
    ...(device ? ['device'] : []),
  ].join(',');
}

/**
 * One line of a trace file: three digits after the point, 1 for a bright floor, empty for no distance and for a sensor
 * that this robot does not have.
 */
export function traceLine(row: TraceRow, { sensors, device }: TraceColumns): string {
  const brightness = (name: string): number | null => {
    const sensor = row.lineSensors.find((one) => one.name === name);
    return sensor === undefined ? null : Number(sensor.bright);
  };
  const cells = [
    row.timeUs / 1000,
    row.xMm,
    row.yMm,
    wrappedDeg(degOf(row.headingRad)),
    row.leftMmPerS,
    row.rightMmPerS,
    row.leftDuty,
    row.rightDuty,
    ...sensors.map(brightness),
    row.distanceMm,
    row.collisions,
  ];
  const line = cells.map((cell) => (cell === null ? '' : String(rounded(cell)))).join(',');
  return device ? `${line},${quoted(row.device)}` : line;
}

/** RFC 4180: a name with a comma, a quote or a line break is quoted. */
const quoted = (text: string): string => (/[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
