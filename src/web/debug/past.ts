import { watch } from 'vue';

import type { LineStep } from '#vm/debug/stops';
import type { Variables } from '#vm/debug/variables';
import { lookAt } from '../run/look-at';
import { LookClient, type Instant, type Look, type LookClientOptions, type LookWish } from '../run/look-client';
import type { RunParts } from '../run/parts';
import type { Recording } from '../run/recording';
import type { WorkParts } from '../work/model/parts';

/** What the past needs of the page around it. */
export interface PastParts extends Pick<RunParts, 'run'>, Pick<WorkParts, 'work'> {
  /** How workers are made, and the VM for them. */
  readonly engine: Pick<LookClientOptions, 'createWorker' | 'firmware'>;
}

/** Lines and variables of moments that have been: the run is run again up to them. */
export class Past {
  private client: { readonly of: Recording; readonly inputs: number; readonly client: LookClient } | null = null;
  /** The moment that was found last, while it is the one that is shown. */
  private found: Look | null = null;
  /** Ways to other lines that are under way. */
  private goings = 0;

  /** @param tell hears the variables of the moment that is shown */
  constructor(
    private readonly app: PastParts,
    private readonly tell: (device: number, variables: Variables) => void,
  ) {
    watch(app.run.recording, () => this.end());
  }

  /** Asks for the variables of the moment that is shown. */
  async look(): Promise<void> {
    if (this.goings > 0 || this.isFound()) return;
    const at = this.instant();
    const look = at === null ? null : await this.ask({ kind: 'moment', at });
    if (look !== null && this.instant()?.timeUs === at?.timeUs) this.tell(look.device, look.variables);
  }

  /** From the moment that is shown, or from now, to the line that began before. */
  back(): Promise<void> {
    const at = this.instant() ?? this.present();
    return this.go({ kind: 'back', at });
  }

  /** From the moment that is shown on to another line, as far as the run has come. */
  async step(step: LineStep): Promise<void> {
    const at = this.instant();
    const untilUs = this.app.run.present.value?.timeUs ?? 0;
    if (at !== null) await this.go({ kind: 'step', at, step, untilUs });
  }

  /** To the line that has raised the error by which the program ended. @param line the one that the error names */
  toError(timeUs: number, line: number | null): Promise<void> {
    return this.go({ kind: 'error', at: { device: this.device, timeUs, isLine: false }, line });
  }

  private get device(): number {
    return this.app.work.place.value;
  }

  private async go(wish: LookWish): Promise<void> {
    const { run } = this.app;
    run.lookBack();
    this.goings += 1;
    const look = await this.ask(wish).finally(() => (this.goings -= 1));
    if (look === null || run.past.value === null) return;
    this.found = look;
    run.past.value = look.snapshot; // on a phone the time line may be behind another tab
    lookAt(run, look.snapshot.timeUs, look.snapshot);
    this.tell(look.device, look.variables);
  }

  /** The moment that is shown is the one that was found. */
  private isFound(): boolean {
    return this.found !== null && this.found.snapshot === this.app.run.past.value && this.found.device === this.device;
  }

  private instant(): Instant | null {
    const past = this.app.run.past.value;
    if (past === null) return null;
    if (this.isFound()) return this.found;
    return past === this.app.run.present.value
      ? this.present()
      : { device: this.device, timeUs: past.timeUs, isLine: false };
  }

  private present(): Instant {
    const held = this.app.run.debug.held.value;
    const timeUs = this.app.run.present.value?.timeUs ?? 0;
    const { device } = this;
    const isHeld = held?.device === device && held.timeUs >= timeUs;
    return isHeld ? { device, timeUs: held.timeUs, isLine: true } : { device, timeUs, isLine: false };
  }

  private async ask(wish: LookWish): Promise<Look | null> {
    const { run, engine } = this.app;
    const recording = run.recording.value;
    const { setup } = recording;
    const inputs = recording.inputs.value ?? (await this.inputsOf(recording));
    if (setup === null || inputs === null || recording !== run.recording.value) return null;
    // What was done to a run is only ever added to.
    if (this.client?.of !== recording || this.client.inputs !== inputs.length) {
      this.client?.client.end();
      const client = new LookClient({ ...engine, setup: { ...setup, inputs } });
      this.client = { of: recording, inputs: inputs.length, client };
    }
    return this.client.client.look(wish);
  }

  /** What was done to the run comes a moment after somebody looks back. */
  private inputsOf(recording: Recording): Promise<Recording['inputs']['value']> {
    return new Promise((resolve) => {
      const stop = watch([recording.inputs, this.app.run.recording], ([inputs, now]) => {
        if (inputs === null && now === recording) return;
        stop();
        resolve(inputs);
      });
    });
  }

  private end(): void {
    this.client?.client.end();
    this.client = this.found = null;
  }
}
