import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import type { Snapshot } from '#simulation/snapshot';
import type { Asked, Recording } from './recording';
import type { WhyAsked } from './why-asked';

/** The only way to start and end looking back at a run. */
export class LookPort {
  private readonly moment: ShallowRef<Snapshot | null> = shallowRef(null);
  /** The moment shown instead of the present; `null`: the page shows the present. */
  readonly past: Readonly<ShallowRef<Snapshot | null>> = this.moment;

  /**
   * True if the moment that is looked at is the present one. By its time: the run sends further pictures of the moment
   * at which it stands.
   */
  readonly isAtPresent: ComputedRef<boolean> = computed(
    () => this.past.value !== null && this.past.value.timeUs === this.run.present.value?.timeUs,
  );

  /** True if a moment before the present one is looked at: what is known of the run's end does not belong to it. */
  readonly isEarlier: ComputedRef<boolean> = computed(() => this.past.value !== null && !this.isAtPresent.value);

  /** @param hold pauses simulated time, and requests the newest moments for the recording */
  constructor(
    private readonly run: Readonly<{ present: ShallowRef<Snapshot | null>; recording: ShallowRef<Recording> }>,
    private readonly hold: () => void,
  ) {}

  /** Pauses the run and looks back, at first at the present. */
  back(): void {
    this.hold();
    this.moment.value ??= this.run.present.value;
  }

  /**
   * Looks back at a moment. @param exact the moment itself, if it is known better than on the tape; it is shown
   * immediately
   */
  at(timeUs: number, exact?: Snapshot): void {
    this.back();
    if (exact !== undefined) this.moment.value = exact;
    this.run.recording.value.ask({ timeUs, ...(exact && { exact }) });
  }

  /** Shows another moment while looking back; otherwise does nothing. */
  show(moment: Snapshot): void {
    if (this.past.value !== null) this.moment.value = moment;
  }

  /** Asks for the lines that caused something visible at a moment. */
  why(question: WhyAsked): void {
    if (this.past.value === null) this.back();
    this.run.recording.value.askWhy(question);
  }

  /** Leaves the past: the present is shown. */
  leave(): void {
    this.moment.value = null;
    this.run.recording.value.ask(null);
  }

  /**
   * Another run begins. @param shown the moment shown until it has caught up @param asked the moment to go to in the
   * meantime
   */
  begin(shown: Snapshot | null = null, asked: Asked | null = null): void {
    this.moment.value = shown;
    this.run.recording.value.ask(asked);
  }
}
