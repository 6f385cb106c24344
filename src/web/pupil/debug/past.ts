import { shallowRef, watch, type ShallowRef } from 'vue';

import type { Cause } from '#simulation/causes/causes';
import type { CodeLine } from '#simulation/causes/output';
import type { LineStep } from '#vm/debug/stops';
import type { Variables } from '#vm/debug/variables';
import {
  LookClient,
  type Instant,
  type Look,
  type LookClientOptions,
  type LookWish,
  type WhyWish,
} from '../../session/run/look-client';
import type { RunParts } from '../../session/run/parts';
import type { Recording } from '../../session/run/recording';
import type { WorkParts } from '../../session/work/model/parts';

/** The models that looking at the past needs. */
export interface PastParts extends Pick<RunParts, 'run'>, Pick<WorkParts, 'work'> {
  /** How workers are made, and the VM for them. */
  readonly engine: Pick<LookClientOptions, 'createWorker' | 'firmware'>;
}

/** Lines and variables of moments that have been: the run is run again up to them. */
export class Past {
  /** The moment of the line that a step or a jump has reached last. */
  readonly arrived: ShallowRef<Look | null> = shallowRef(null);
  private client: { readonly of: Recording; readonly inputs: number; readonly client: LookClient } | null = null;
  /** The moment that was found last, while it is the one that is shown. */
  private found: Look | null = null;
  /** Number of steps and jumps that are under way. */
  private goings = 0;

  /** @param tell called with the variables of the moment that is shown */
  constructor(
    private readonly app: PastParts,
    private readonly tell: (device: number, variables: Variables) => void,
  ) {
    watch(app.run.recording, () => this.end());
  }

  /** Asks for the variables of the moment that is shown. */
  async look(): Promise<void> {
    const { device } = this;
    if (this.goings > 0 || this.isFound(device)) return;
    const look = await this.moment(device);
    if (look !== null) this.tell(look.device, look.variables);
  }

  /**
   * The moment that is shown, for any device. Meanwhile the page requests none itself: its request would overtake this
   * one.
   *
   * @returns `null`: another one is shown by now, or nothing can be seen
   */
  async momentOf(device: number): Promise<Look | null> {
    if (this.isFound(device)) return this.found;
    this.goings += 1;
    const look = await this.moment(device).finally(() => (this.goings -= 1));
    if (look !== null && device === this.device) this.tell(look.device, look.variables);
    return look;
  }

  private async moment(device: number): Promise<Look | null> {
    const at = this.instant(device);
    const look = at === null ? null : await this.ask({ kind: 'moment', at });
    return this.instant(device)?.timeUs === at?.timeUs ? look : null;
  }

  /**
   * From the moment that is shown, or from now, to the line that began before. In the midst of a line that is the one
   * before it: its own beginning would look the same.
   *
   * @returns whether there is one
   */
  back(device = this.device): Promise<boolean> {
    const at = this.instant(device) ?? this.present(device);
    const position = at.isLine ? null : (this.app.run.deviceNow(device)?.position ?? null);
    return this.go({ kind: 'back', at, within: position && { file: position.file, line: position.line } });
  }

  /** From the moment that is shown on to another line, as far as the run has come. @returns whether there is one */
  async step(step: LineStep, device = this.device): Promise<boolean> {
    const at = this.instant(device);
    const untilUs = this.app.run.present.value?.timeUs ?? 0;
    return at !== null && this.go({ kind: 'step', at, step, untilUs });
  }

  /** To the line that has raised the error by which the program ended. @param line the one that the error names */
  toError(timeUs: number, line: number | null): Promise<boolean> {
    return this.go({ kind: 'error', at: { device: this.device, timeUs, isLine: false }, line });
  }

  /** To the moment at which a line has set something. */
  toCause(
    { device, sinceUs }: { readonly device: number; readonly sinceUs: number },
    place: CodeLine,
  ): Promise<boolean> {
    return this.go({ kind: 'line', at: { device, timeUs: sinceUs, isLine: false }, place });
  }

  /** The lines that have set the outputs. `null`: they cannot be found, or something else was requested meanwhile. */
  async why(wish: WhyWish): Promise<readonly Cause[] | null> {
    return (await this.clientNow())?.why(wish) ?? null;
  }

  /**
   * Gets ready for the first question: the run is repeated up to the present while nobody waits, else they would wait
   * for all of it.
   */
  async prepare(): Promise<void> {
    if (this.app.run.past.value === null) return;
    await (await this.clientNow())?.prepare(this.present(this.device));
  }

  private get device(): number {
    return this.app.work.place.value;
  }

  private async go(wish: LookWish): Promise<boolean> {
    const { run } = this.app;
    run.look.back();
    this.goings += 1;
    const look = await this.ask(wish).finally(() => (this.goings -= 1));
    if (look === null || run.past.value === null) return false;
    this.found = look;
    run.look.at(look.snapshot.timeUs, look.snapshot);
    this.tell(look.device, look.variables);
    this.arrived.value = look;
    return true;
  }

  /** True if the moment that is shown is the one that was found. */
  private isFound(device: number): boolean {
    return this.found !== null && this.found.snapshot === this.app.run.past.value && this.found.device === device;
  }

  private instant(device: number): Instant | null {
    const past = this.app.run.past.value;
    if (past === null) return null;
    if (this.isFound(device)) return this.found;
    return this.app.run.look.isAtPresent.value ? this.present(device) : { device, timeUs: past.timeUs, isLine: false };
  }

  private present(device: number): Instant {
    const held = this.app.run.debug.held.value;
    const timeUs = this.app.run.present.value?.timeUs ?? 0;
    const isHeld = held?.device === device && held.timeUs >= timeUs;
    return isHeld ? { device, timeUs: held.timeUs, isLine: true } : { device, timeUs, isLine: false };
  }

  private async ask(wish: LookWish): Promise<Look | null> {
    return (await this.clientNow())?.look(wish) ?? null;
  }

  private async clientNow(): Promise<LookClient | null> {
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
    return this.client.client;
  }

  /** The inputs to the run, which arrive a moment after looking back begins. */
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
