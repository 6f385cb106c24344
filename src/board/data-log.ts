import type { Stop } from '#core/stop';

/** Something that happened to the log. A row without values is a row of headings alone. */
export type LogEvent =
  | { readonly type: 'row'; readonly headings: readonly string[]; readonly values: readonly string[] }
  | { readonly type: 'clear' }
  | { readonly type: 'full' };

/** One value of a row. */
export type LogEntry = readonly [heading: string, value: string];

/** Units of the timestamp. From the second on, the value is the ms in a hundredth of the unit (MicroBitLog.h). */
const UNITS: ReadonlyMap<number, string> = new Map([
  [1, 'milliseconds'],
  [10, 'seconds'],
  [600, 'minutes'],
  [36_000, 'hours'],
  [864_000, 'days'],
]);
/** No timestamp. */
export const NO_TIMESTAMP = 0;
const MILLISECONDS = 1;

/** micropython-microbit-v2-simulator data-logging.ts: free bytes that a program on the device found. */
export const LOG_BYTES = 118_780;

/**
 * The table in the flash memory. Columns are only ever added, at the end; the timestamp is the first if it is
 * requested before anything is logged. The table survives resets. Source: codal-microbit-v2 MicroBitLog.cpp.
 */
export class DataLog {
  private text = '';
  private bytes = 0;
  private columns: string[] = [];
  private headingsChanged = false;
  private timestamp = NO_TIMESTAMP;
  private timestampChanged = false;
  private full = false;
  private mirror: ((line: string) => void) | null = null;
  private readonly listeners: ((event: LogEvent) => void)[] = [];

  /** Everything logged so far: comma-separated, a line of headings whenever they changed. */
  get csv(): string {
    return this.text;
  }

  /** Its length in bytes, out of 118,780. */
  get byteCount(): number {
    return this.bytes;
  }

  /** True once a row did not fit, until the log is deleted. */
  get isFull(): boolean {
    return this.full;
  }

  /** The columns so far. */
  get headings(): readonly string[] {
    return [...this.columns];
  }

  /** Mirrors every logged line, without its end, to this function; `null` for none. */
  mirrorTo(mirror: ((line: string) => void) | null): void {
    this.mirror = mirror;
  }

  /** @param unit 1, 10, 600, 36,000 or 864,000 for ms, s, min, h, days; 0 for none; another one has no name */
  setTimestamp(unit: number): void {
    if (unit === this.timestamp && unit === NO_TIMESTAMP) return;
    if (this.bytes === 0 && this.columns.length > 0) {
      if (unit !== NO_TIMESTAMP && this.columns[0] === headingOf(unit)) return;
      // Until something is logged, the timestamp's column may still be replaced.
      if (this.timestamp !== NO_TIMESTAMP) this.columns.shift();
    }
    this.timestamp = unit;
    this.timestampChanged = true;
  }

  /**
   * Logs one row; unknown columns are added. If all its values are empty, only new headings are logged.
   *
   * @param nowMs the board's own time, for the timestamp
   * @returns false when the log is full
   */
  add(entries: readonly LogEntry[], nowMs: number): boolean {
    const row = new Map<string, string>();
    for (const [heading, value] of entries) this.put(row, clean(heading), clean(value));
    if (this.timestampChanged) {
      this.timestampChanged = false;
      if (this.timestamp !== NO_TIMESTAMP) this.addColumn(headingOf(this.timestamp), this.bytes === 0);
    }
    const hasData = [...row.values()].some((value) => value !== '');
    if (hasData && this.timestamp !== NO_TIMESTAMP)
      this.put(row, headingOf(this.timestamp), timeText(nowMs, this.timestamp));
    const values = hasData ? this.columns.map((column) => row.get(column) ?? '') : [];
    const headingsWritten = this.headingsChanged && this.write(this.columns.join(','));
    this.headingsChanged = false;
    const rowWritten = hasData && this.write(values.join(','));
    if (headingsWritten || rowWritten)
      this.tell({ type: 'row', headings: [...this.columns], values: rowWritten ? values : [] });
    return !this.full;
  }

  /** Empties the log, columns included. The timestamp stays as it was set. */
  delete(): void {
    this.text = '';
    this.bytes = 0;
    this.columns = [];
    this.headingsChanged = false;
    this.timestampChanged = this.timestamp !== NO_TIMESTAMP;
    this.full = false;
    this.tell({ type: 'clear' });
  }

  /** Empties the log when a program writes a new `main.py`, because it is then worthless. */
  invalidate(): void {
    if (this.bytes > 0 || this.columns.length > 0) this.delete();
  }

  /** Reports what happens to the log. */
  onEvent(listener: (event: LogEvent) => void): Stop {
    this.listeners.push(listener);
    return () => {
      const place = this.listeners.indexOf(listener);
      if (place >= 0) this.listeners.splice(place, 1);
    };
  }

  /** Back to the state after a start of the board: no mirror, no timestamp. The logged rows stay. */
  reset(): void {
    this.mirror = null;
    this.timestamp = NO_TIMESTAMP;
    this.timestampChanged = false;
  }

  private put(row: Map<string, string>, heading: string, value: string): void {
    this.addColumn(heading, false);
    row.set(heading, value);
  }

  private addColumn(heading: string, first: boolean): void {
    if (this.columns.includes(heading)) return;
    if (first) this.columns.unshift(heading);
    else this.columns.push(heading);
    this.headingsChanged = true;
  }

  /** @returns whether it fitted */
  private write(line: string): boolean {
    const bytes = new TextEncoder().encode(line).length + 1;
    if (this.bytes + bytes > LOG_BYTES) {
      if (!this.full) {
        this.full = true;
        this.tell({ type: 'full' });
      }
      return false;
    }
    this.mirror?.(line);
    this.bytes += bytes;
    this.text += `${line}\n`;
    return true;
  }

  private tell(event: LogEvent): void {
    for (const tell of [...this.listeners]) tell(event);
  }
}

const headingOf = (unit: number): string => `Time (${UNITS.get(unit) ?? ''})`;

/** Whole ms, or the unit with two decimals, both truncated. */
function timeText(nowMs: number, unit: number): string {
  if (unit === MILLISECONDS) return String(nowMs);
  if (unit < 0) return '0'; // divided by what is a number without a sign
  const hundredths = Math.floor(nowMs / unit);
  return `${Math.floor(hundredths / 100)}.${String(hundredths % 100).padStart(2, '0')}`;
}

/** Replaces characters that would break the table by underscores. */
function clean(text: string): string {
  return text.replaceAll('-->', '___').replaceAll(/[\t,\n]/g, '_');
}
