import { shallowRef, type ShallowRef } from 'vue';

import type { InputEvent } from '#simulation/input';

import type { RunModel } from './run-model';

/** A hand on the sensors of the board: what it set holds for this run and the ones to come, until it is taken back. */
export class SensorsModel {
  /** What was set by hand, by sensor id; everything else is as the board has it at its start. */
  readonly wishes: ShallowRef<Readonly<Record<string, number>>> = shallowRef({});

  constructor(private readonly run: Pick<RunModel, 'input'>) {}

  /** Sets a sensor, now and at the start of every further run. */
  set(id: string, value: number): void {
    this.wishes.value = { ...this.wishes.value, [id]: value };
    this.run.input({ type: 'sensor', id, value });
  }

  /** A movement of the board: each call reports it to the program again. */
  gesture(name: string): void {
    this.run.input({ type: 'sensor', id: 'gesture', value: name });
  }

  /** Back to what the board feels at its start. @param starts the value there, by sensor id */
  reset(starts: ReadonlyMap<string, number>): void {
    for (const id of Object.keys(this.wishes.value)) {
      const value = starts.get(id);
      if (value !== undefined) this.run.input({ type: 'sensor', id, value });
    }
    this.wishes.value = {};
  }

  /** What a run has to be given at its start. */
  startInputs(): readonly InputEvent[] {
    return Object.entries(this.wishes.value).map(([id, value]) => ({
      timeUs: 0,
      action: { type: 'sensor' as const, id, value },
    }));
  }
}
