import type { Stop } from '#core/stop';

/** The level that a digital input reads from a wire: 0 = low, 1 = high. */
export type Level = 0 | 1;

/** The resistor that decides while nothing drives. */
export type Pull = 'up' | 'down' | 'none';

/** A pulse-width modulated output. */
export interface Pwm {
  /** Length of one period in µs, at least 1. */
  readonly periodUs: number;
  /** Share of the period that is high, 0 … 1. */
  readonly dutyFraction: number;
}

/** Bytes on a serial line, least significant bit first, one start and one stop bit each. */
export interface SerialFrame {
  readonly bytes: Uint8Array;
  /** Bits per second. */
  readonly baud: number;
}

/** The signal that one end drives its wire with. Rule ids: see SPEC.md. */
type Drive =
  | { readonly kind: 'level'; readonly level: Level }
  | { readonly kind: 'analog'; readonly fraction: number }
  | { readonly kind: 'pwm'; readonly pwm: Pwm };

/** One participant's connection to a wire. A new end neither drives nor pulls. */
export interface WireEnd {
  readonly owner: string;
  /** Drives low or high, replacing what this end drove before. Low wins over everything else that drives (rule W2). */
  drive(level: Level): void;
  /**
   * Drives low or high from now on, but says which only once somebody asks, or at once where somebody listens (rule W12).
   *
   * @param level gives the level at the moment at which it is asked: at most once after each call
   */
  driveLate(level: () => Level): void;
  /** Drives a voltage as a fraction of the supply, clamped to 0 … 1. */
  driveAnalog(fraction: number): void;
  /** Drives a PWM signal. */
  drivePwm(pwm: Pwm): void;
  /** Stops driving (high impedance). The pull stays. */
  release(): void;
  pull(pull: Pull): void;
  /** Stops driving and pulling, and leaves the wire. */
  readonly detach: Stop;
}

interface EndState {
  readonly owner: string;
  drive: Drive | null;
  pull: Pull;
}

/**
 * A conductor between the microcomputer and chips. Several ends may be connected; SPEC.md says which one wins.
 * Listeners run at once, in the order in which they were attached. A change made by a listener is reported after the
 * present round, so that all listeners see the changes in the same order.
 */
export class Wire {
  private readonly ends: EndState[] = [];
  private readonly levelListeners: Listeners<Level> = new Set();
  private readonly pwmListeners: Listeners<Pwm | null> = new Set();
  private readonly streamListeners: Listeners<Uint8Array> = new Set();
  private readonly serialListeners: Listeners<SerialFrame> = new Set();
  private readonly changes: (() => void)[] = [];
  private telling = false;
  /** An end that has not been asked yet what it drives by now. */
  private late: { readonly end: WireEnd; level: () => Level } | null = null;
  private settled: Level = 0;
  private settledPwm: Pwm | null = null;

  constructor(readonly name: string) {}

  /** The present digital level. */
  get level(): Level {
    this.hear();
    return this.settled;
  }

  /** The PWM signal on the wire, or `null` without one. */
  get pwm(): Pwm | null {
    this.hear();
    return this.settledPwm;
  }

  /** The mean voltage as a fraction of the supply, 0 … 1: the value that an analog input measures. */
  get fraction(): number {
    this.hear();
    const drive = this.winner();
    switch (drive?.kind) {
      case 'analog':
        return drive.fraction;
      case 'pwm':
        return drive.pwm.dutyFraction;
      case 'level':
      case undefined:
        return this.settled;
    }
  }

  /** True while nobody drives the wire and nobody pulls it. */
  get isOpen(): boolean {
    this.hear();
    return this.ends.every(({ drive, pull }) => drive === null && pull === 'none');
  }

  /** Connects a participant. */
  connect(owner: string): WireEnd {
    const end: EndState = { owner, drive: null, pull: 'none' };
    this.ends.push(end);
    const set = (drive: Drive | null): void => {
      this.hear();
      end.drive = drive;
      this.settle();
    };
    // What an end does already changes nothing: programs ask for it in loops.
    const drives = (level: Level): boolean => end.drive?.kind === 'level' && end.drive.level === level;
    const drive = (level: Level): void => {
      this.hear();
      if (!drives(level)) set({ kind: 'level', level });
    };
    const connected: WireEnd = {
      owner,
      drive,
      driveLate: (level) => {
        if (this.levelListeners.size > 0) return drive(level());
        if (this.late?.end !== connected) this.hear();
        this.late ??= { end: connected, level };
        this.late.level = level;
      },
      driveAnalog: (fraction) => set({ kind: 'analog', fraction: Math.min(1, Math.max(0, fraction)) }),
      drivePwm: (pwm) => set({ kind: 'pwm', pwm }),
      release: () => {
        this.hear();
        if (end.drive !== null) set(null);
      },
      pull: (pull) => {
        if (pull === end.pull) return;
        this.hear();
        end.pull = pull;
        this.settle();
      },
      detach: () => {
        const place = this.ends.indexOf(end);
        if (place < 0) return;
        this.hear();
        this.ends.splice(place, 1);
        this.settle();
      },
    };
    return connected;
  }

  /** Reports every change of the digital level. */
  onLevel(listener: (level: Level) => void): Stop {
    this.hear();
    return attach(this.levelListeners, listener);
  }

  /** Reports when a PWM signal starts, changes or (`null`) ends. */
  onPwm(listener: (pwm: Pwm | null) => void): Stop {
    return attach(this.pwmListeners, listener);
  }

  /**
   * Receives the bytes of a one-wire LED stream (ws2812), most significant bit first as sent. They may be a view of
   * other memory: copy them to store them.
   */
  onStream(listener: (bytes: Uint8Array) => void): Stop {
    return attach(this.streamListeners, listener);
  }

  /** Number of listeners for LED streams. More than one's own means that the LEDs have an owner (rule S4). */
  get streamListenerCount(): number {
    return this.streamListeners.size;
  }

  /** Sends an LED stream. The level does not change: afterwards the wire is where its ends leave it (rule S2). */
  stream(bytes: Uint8Array): void {
    tellAll(this.streamListeners, bytes);
  }

  /** Receives what is sent over this wire as a serial line. The bytes may be a view of other memory. */
  onSerial(listener: (frame: SerialFrame) => void): Stop {
    return attach(this.serialListeners, listener);
  }

  /** Sends bytes as a serial line does; they count as received now. The level does not change (rule U2). */
  serial(frame: SerialFrame): void {
    tellAll(this.serialListeners, frame);
  }

  /** Low wins over high, and driving (level, analog, PWM) wins over a pull: rules W2, W3. */
  private winner(): Drive | undefined {
    let winner: Drive | undefined;
    for (const { drive } of this.ends) {
      if (!drive) continue;
      if (drive.kind === 'level' && drive.level === 0) return drive;
      winner ??= drive;
    }
    return winner;
  }

  /** Asks what an end drives by now, before anybody learns what is on the wire, or changes it. */
  private hear(): void {
    const { late } = this;
    this.late = null;
    late?.end.drive(late.level());
  }

  private settle(): void {
    const drive = this.winner();
    const level = drive ? levelOf(drive, this.settled) : this.pulledLevel();
    const pwm = drive?.kind === 'pwm' ? drive.pwm : null;
    if (level !== this.settled) {
      this.settled = level;
      this.changes.push(() => tellAll(this.levelListeners, level));
    }
    if (pwm !== this.settledPwm) {
      this.settledPwm = pwm;
      this.changes.push(() => tellAll(this.pwmListeners, pwm));
    }
    this.tell();
  }

  private tell(): void {
    if (this.telling) return;
    this.telling = true;
    try {
      for (let change = this.changes.shift(); change; change = this.changes.shift()) change();
    } finally {
      this.telling = false;
    }
  }

  /** Up wins when both directions pull (rule W5); without any pull a floating wire reads 0 (rule W6). */
  private pulledLevel(): Level {
    return this.ends.some((end) => end.pull === 'up') ? 1 : 0;
  }
}

/** Input thresholds (nRF52833 product specification, GPIO): 0.7 and 0.3 × VDD; in between the level stays (rule W7). */
function levelOf(drive: Drive, before: Level): Level {
  if (drive.kind === 'level') return drive.level;
  const fraction = drive.kind === 'analog' ? drive.fraction : drive.pwm.dutyFraction;
  if (fraction >= 0.7) return 1;
  if (fraction <= 0.3) return 0;
  return before;
}

interface Listener<T> {
  readonly tell: (news: T) => void;
}
type Listeners<T> = Set<Listener<T>>;

function attach<T>(listeners: Listeners<T>, tell: (news: T) => void): Stop {
  const listener = { tell };
  listeners.add(listener);
  return () => {
    listeners.delete(listener);
  };
}

/** Notifies the present listeners; one that is stopped meanwhile is not notified any more (rule W10). */
function tellAll<T>(listeners: Listeners<T>, news: T): void {
  for (const listener of [...listeners]) if (listeners.has(listener)) listener.tell(news);
}
