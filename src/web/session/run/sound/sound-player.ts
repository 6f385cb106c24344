import { shallowRef, type ShallowRef } from 'vue';

import type { SoundEvent } from '#board/sound/sound-event';

import { createSoundClock } from './sound-clock';
import type { SoundMixer, Synthesis } from './sound-mixer';

/** Silence after which the sound system is put to sleep, in ms: awake, it constantly costs a weak tablet a few percent. */
const SLEEP_AFTER_MS = 3000;
/** Time the browser may take to start sound, in ms. */
const BLOCKED_AFTER_MS = 400;

/** The sound system; its mixer is fetched with the first sound. */
interface System {
  readonly context: AudioContext;
  mixer: SoundMixer | null;
}

/** The module that mixes. */
interface Mixing {
  readonly SoundMixer: new (context: BaseAudioContext) => SoundMixer;
}

/** True if an event can be played only once the synthesis is loaded. */
const needsSynthesis = (event: SoundEvent): boolean => event.type === 'effect' || event.type === 'speech';

/** The output for sounds other than the board's. */
export interface SoundOutput {
  readonly context: BaseAudioContext;
  readonly to: AudioNode;
}

/** Plays the board's sound. The sound system itself is created with the first sound, or by `wake`. */
export class SoundPlayer {
  /** True while the browser blocks a sound: a tap on the page lets it play. */
  readonly isBlocked: ShallowRef<boolean> = shallowRef(false);
  private readonly clock = createSoundClock();
  private system: System | null = null;
  private mixing: Mixing | null = null;
  private synthesis: Synthesis | null = null;
  private isLoading = false;
  private speed = 0;
  private muted = false;
  /** State that lasts until it is changed. It is followed even while muted, so that the right sound can return. */
  private readonly lasting = new Map<SoundEvent['type'], SoundEvent>();
  /** Events that wait for the mixer or the synthesis. */
  private waiting: readonly SoundEvent[] = [];
  private sleep: ReturnType<typeof setTimeout> | undefined;
  private check: ReturnType<typeof setTimeout> | undefined;

  /** Takes the events of the run's sound hardware, oldest first. */
  take(events: readonly SoundEvent[]): void {
    for (const event of events) this.remember(event);
    if (!this.isHeard || events.length === 0) return;
    this.playSoon(events);
  }

  /** A new run begins: silence, full volume, speaker on. */
  start(): void {
    this.stop();
    this.system?.mixer?.reset();
    this.lasting.clear();
  }

  /** Silence. */
  stop(): void {
    this.waiting = [];
    this.clock.reset();
    this.system?.mixer?.stop();
    clearTimeout(this.check);
    this.isBlocked.value = false;
  }

  /** Speed of simulated time; 0 while paused. Above 1 nothing is heard. */
  setSpeed(speed: number): void {
    this.change(() => (this.speed = speed));
  }

  setMuted(muted: boolean): void {
    this.change(() => (this.muted = muted));
  }

  /** To be called while a tap or key press is handled: only then do browsers let sound begin. */
  wake(): void {
    if (!this.muted) this.open();
  }

  /**
   * The output for the page's other sounds, awake for some seconds; `null` if muted, not loaded yet, or without sound
   * hardware.
   */
  output(): SoundOutput | null {
    const system = this.muted ? null : this.open();
    if (system !== null && system.mixer === null) void this.load();
    return system?.mixer ? { context: system.context, to: system.mixer.out } : null;
  }

  dispose(): void {
    clearTimeout(this.sleep);
    clearTimeout(this.check);
    void this.system?.context.close().catch(() => undefined);
    this.system = null;
  }

  private get isHeard(): boolean {
    return !this.muted && this.speed > 0 && this.speed <= 1;
  }

  private remember(event: SoundEvent): void {
    if (event.type === 'tone' && event.hz === null) this.lasting.delete('tone');
    else if (event.type === 'tone' || event.type === 'volume' || event.type === 'output') {
      this.lasting.set(event.type, event);
    }
  }

  /** Applies a change that may affect whether the board is heard; a sound that is still playing is resumed. */
  private change(apply: () => void): void {
    const before = this.isHeard;
    apply();
    if (before === this.isHeard) return;
    if (before) this.stop();
    else if (this.lasting.size > 0) this.playSoon([...this.lasting.values()].map((event) => ({ ...event, timeUs: 0 })));
    this.clock.reset();
  }

  /** Plays events as soon as all that they need is loaded. */
  private playSoon(events: readonly SoundEvent[]): void {
    const isMissing = this.mixing === null || (this.synthesis === null && events.some(needsSynthesis));
    if (this.waiting.length === 0 && !isMissing) {
      this.play(events);
      return;
    }
    this.waiting = [...this.waiting, ...events];
    void this.load();
  }

  private play(events: readonly SoundEvent[]): void {
    const { context, mixer } = this.open() ?? {};
    if (isBeforeGesture()) this.checkLater();
    if (!context || !mixer) return;
    if (context.state !== 'running') this.checkLater();
    for (const event of events) {
      mixer.play(event, this.clock.at(event.timeUs, context.currentTime, this.speed), this.synthesis);
    }
  }

  private async load(): Promise<void> {
    if (this.isLoading) return;
    this.isLoading = true;
    try {
      this.mixing ??= await import('./sound-mixer');
      if (this.waiting.some(needsSynthesis)) this.synthesis ??= await import('./synthesis');
    } catch {
      // Tones need no synthesis: they play even if it cannot be loaded.
    }
    this.isLoading = false;
    const events = this.waiting;
    this.waiting = [];
    if (this.isHeard) this.play(events);
  }

  private open(): System | null {
    if (this.system === null && isBeforeGesture()) return null;
    try {
      this.system ??= this.create();
      if (this.mixing) this.system.mixer ??= new this.mixing.SoundMixer(this.system.context);
      if (this.system.context.state !== 'running') this.system.context.resume().catch(() => undefined);
      this.sleepLater(this.system);
    } catch {
      return null; // without sound hardware, programs run all the same
    }
    return this.system;
  }

  private create(): System {
    const context = new AudioContext({ latencyHint: 'interactive' });
    context.onstatechange = () => {
      if (context.state === 'running') this.isBlocked.value = false;
    };
    return { context, mixer: null };
  }

  /** Puts the sound system to sleep some time after the last sound. */
  private sleepLater(system: System): void {
    const { context } = system;
    clearTimeout(this.sleep);
    this.sleep = setTimeout(() => {
      if (context.state !== 'running') return;
      if ((system.mixer?.endS ?? 0) > context.currentTime) this.sleepLater(system);
      else context.suspend().catch(() => undefined);
    }, SLEEP_AFTER_MS);
  }

  /** Checks, a while after something should have been heard, whether the browser allows it. */
  private checkLater(): void {
    clearTimeout(this.check);
    this.check = setTimeout(() => {
      const { system } = this;
      this.isBlocked.value =
        this.isHeard && (system === null ? isBeforeGesture() : system.context.state === 'suspended');
    }, BLOCKED_AFTER_MS);
  }
}

/**
 * True if nobody has tapped or typed on the page yet, as when a run is opened from a link: a sound system that is made
 * now would be refused with a warning. In a frame the host may have allowed it.
 */
const isBeforeGesture = (): boolean =>
  window.parent === window && (navigator as Partial<Navigator>).userActivation?.hasBeenActive === false;
