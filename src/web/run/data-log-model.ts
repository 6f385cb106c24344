import { shallowRef, type ShallowRef } from 'vue';

import type { DeviceLog } from '#device-log/device-log';
import { emptyLog, withLogEvents, type LogTable } from '#simulation/log-table';
import type { TimedLogEvent } from '#simulation/outlets';

/** What a real board has logged, and the file it is from. */
export interface OpenedLog {
  readonly file: string;
  readonly log: DeviceLog;
}

/** The board's data log as the page keeps it: every row, because the device's own memory already limits it. */
export class DataLogModel {
  readonly table: ShallowRef<LogTable> = shallowRef(emptyLog);
  readonly isFull = shallowRef(false);
  /** The log of a real board that is open beside the simulated one; no run changes it. */
  readonly device = shallowRef<OpenedLog | null>(null);
  /** Whether both are being looked at. */
  readonly isCompared = shallowRef(false);

  take(events: readonly TimedLogEvent[]): void {
    if (events.length === 0) return;
    for (const { type } of events) {
      if (type === 'full') this.isFull.value = true;
      if (type === 'clear') this.isFull.value = false;
    }
    this.table.value = withLogEvents(this.table.value, events);
  }

  clear(): void {
    this.table.value = emptyLog;
    this.isFull.value = false;
  }
}
