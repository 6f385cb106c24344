import type { SharedLine } from './shared-lines';

/** The lines without the last traceback of a device, which the card of its error has. */
export function withoutTraceback(lines: readonly SharedLine[], device: number): readonly SharedLine[] {
  const start = lines.findLastIndex((line) => line.device === device && line.text.startsWith('Traceback ('));
  if (start < 0) return lines;
  const isOf = (line: SharedLine | undefined): boolean => line?.device === device;
  // It ends with the line that names the exception: the first one that is not indented.
  const end = lines.findIndex((line, index) => index > start && isOf(line) && !line.text.startsWith(' '));
  const last = end < 0 ? lines.length - 1 : end;
  return lines.filter((line, index) => index < start || index > last || !isOf(line));
}
