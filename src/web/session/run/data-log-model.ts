import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import type { DeviceLog } from '#device-log/device-log';
import { emptyLog, withLogEvents, type LogTable } from '#simulation/log-table';
import type { TimedLogEvent } from '#simulation/outlets';

/** The log of a real board, and the file it was read from. */
export interface OpenedLog {
  readonly file: string;
  readonly log: DeviceLog;
}

/** The log of a simulated board. */
interface BoardLog {
  readonly table: LogTable;
  readonly isFull: boolean;
}

/** The boards' data logs as the page stores them: every row, because a device's own memory already limits it. */
export class DataLogModel {
  /** Table of the device that is shown. */
  readonly table: ComputedRef<LogTable> = computed(() => this.boards.value[this.shown()]?.table ?? emptyLog);
  readonly isFull = computed(() => this.boards.value[this.shown()]?.isFull ?? false);
  /** By the place of the device. */
  private readonly boards: ShallowRef<Readonly<Record<number, BoardLog>>> = shallowRef({});
  /** The log of a real board that is open beside the simulated one; no run changes it. */
  readonly device = shallowRef<OpenedLog | null>(null);
  /** True while both are compared. */
  readonly isCompared = shallowRef(false);

  /** @param shown place of the device that is shown */
  constructor(private readonly shown: () => number = () => 0) {}

  /** Adds the logged events of a device. */
  take(events: readonly TimedLogEvent[], device = 0): void {
    if (events.length === 0) return;
    const { table = emptyLog, isFull: wasFull = false } = this.boards.value[device] ?? {};
    let isFull = wasFull;
    for (const { type } of events) if (type === 'full' || type === 'clear') isFull = type === 'full';
    this.boards.value = { ...this.boards.value, [device]: { table: withLogEvents(table, events), isFull } };
  }

  clear(): void {
    this.boards.value = {};
  }
}
