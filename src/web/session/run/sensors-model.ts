import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import type { InputEvent } from '#simulation/input';

import type { RunModel } from './run-model';

/** Values set by hand, by sensor id; everything else is as at the board's start. */
type Wishes = Readonly<Record<string, number>>;

/** Sensor values of a board set by hand: they hold for this run and the next ones, until they are reset. */
export class SensorsModel {
  /** Values set on the device that is shown. */
  readonly wishes: ComputedRef<Wishes> = computed(() => this.all.value[this.run.device] ?? {});
  /** By the place of the device. */
  private readonly all: ShallowRef<Readonly<Record<number, Wishes>>> = shallowRef({});

  constructor(private readonly run: Pick<RunModel, 'input' | 'device'>) {}

  /** Sets a sensor of a device, now and at the start of every further run. @returns whether that may be done */
  set(id: string, value: number, device = this.run.device): boolean {
    const mayBe = this.run.input({ type: 'sensor', id, value }, device);
    if (mayBe) this.put(device, { ...this.all.value[device], [id]: value });
    return mayBe;
  }

  /** A movement of the board: each call reports it to the program again. */
  gesture(name: string): void {
    this.run.input({ type: 'sensor', id: 'gesture', value: name });
  }

  /** Resets to the board's values at its start. @param starts the value there, by sensor id */
  reset(starts: ReadonlyMap<string, number>): void {
    for (const id of Object.keys(this.wishes.value)) {
      const value = starts.get(id);
      if (value !== undefined) this.run.input({ type: 'sensor', id, value });
    }
    this.put(this.run.device, {});
  }

  /** The inputs of a run for a device at its start. */
  startInputs(device = 0): readonly InputEvent[] {
    return Object.entries(this.all.value[device] ?? {}).map(([id, value]) => ({
      timeUs: 0,
      action: { type: 'sensor' as const, id, value },
    }));
  }

  private put(device: number, wishes: Wishes): void {
    this.all.value = { ...this.all.value, [device]: wishes };
  }
}
