import { shallowRef, type ShallowRef } from 'vue';

import type { Snapshot } from '#simulation/snapshot';
import type { Asked, Recording } from './recording';
import type { WhyAsked } from './why-asked';

/** The one way into the past of a run, and out of it. */
export class LookPort {
  private readonly moment: ShallowRef<Snapshot | null> = shallowRef(null);
  /** The moment that is looked at instead of now; `null`: nobody looks back. */
  readonly past: Readonly<ShallowRef<Snapshot | null>> = this.moment;

  /** @param hold lets time stand still, and has the newest moments brought to the recording */
  constructor(
    private readonly run: Readonly<{ present: ShallowRef<Snapshot | null>; recording: ShallowRef<Recording> }>,
    private readonly hold: () => void,
  ) {}

  /** Looks back, at first at now. */
  back(): void {
    this.hold();
    this.moment.value ??= this.run.present.value;
  }

  /** Looks back at a moment. @param exact the moment itself, where it is known better than on the tape; it is shown at once */
  at(timeUs: number, exact?: Snapshot): void {
    this.back();
    if (exact !== undefined) this.moment.value = exact;
    this.run.recording.value.ask({ timeUs, ...(exact && { exact }) });
  }

  /** Shows another moment to those who look back; where nobody does, nothing happens. */
  show(moment: Snapshot): void {
    if (this.past.value !== null) this.moment.value = moment;
  }

  /** Asks for the lines behind something that is seen in a moment. */
  why(question: WhyAsked): void {
    if (this.past.value === null) this.back();
    this.run.recording.value.askWhy(question);
  }

  /** Leaves the past: the present is shown. */
  leave(): void {
    this.moment.value = null;
    this.run.recording.value.ask(null);
  }

  /** Another run begins. @param shown what is shown until it has caught up @param asked the moment to go to meanwhile */
  begin(shown: Snapshot | null = null, asked: Asked | null = null): void {
    this.moment.value = shown;
    this.run.recording.value.ask(asked);
  }
}
