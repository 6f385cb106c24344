/**
 * The simulator as a device of WebTigerPython, or of any page with the same device interface: the device's buttons
 * there act on a frame with Parcours.
 */
import type { Language } from '#core/languages';
import { HOLD_MS, Printing } from '../webtigerpython/printing';
import { connect } from './connect';
import { ParcoursError } from './parcours-error';
import type { ClientEvents, Events, Parcours } from './types';

/** A device in the form of WebTigerPython. Functions that a device does not have are greyed out there. */
export interface DeviceInterface {
  registerDevice(): void;
  disconnectDevice(): void;
  cleanUp(): void;
  flash?(code: string): void;
  runCode?(code: string): void;
  stopCode?(): void;
  exportCode?(code: string): void;
}

/**
 * State of the device. `absent`: not registered, or disconnected; `connecting`: its page loads; `ready`: nothing runs;
 * `ended`: the program is over, while a robot drives on and the REPL answers until Stop; `missing`: its page did not
 * answer.
 */
export type DeviceState = 'absent' | 'connecting' | 'ready' | 'running' | 'ended' | 'missing';

/** The settings and listeners of the device. */
export interface ParcoursDeviceOptions {
  /** The frame that shows Parcours, its window, or a port that leads to it. Instead of `container` and `address`. */
  readonly frame?: HTMLIFrameElement | Window | MessagePort;
  /** Container for a frame of the device's own, while it is registered. */
  readonly container?: HTMLElement;
  /** Address of Parcours for that frame. */
  readonly address?: string;
  /** Name of that frame for screen readers. Default `Parcours`. */
  readonly title?: string;
  /** Id of the microcomputer, such as `microbit-v2` or `calliope-mini-3`; default: by the program's imports. */
  readonly board?: string;
  /** Id of the robot, `none` for the bare board; by default chosen by the program's imports. */
  readonly robot?: string;
  /** The shown parts: `bar`, `code`, `board`, `arena`, `tools`, `console`. By default board and arena. */
  readonly parts?: readonly ('bar' | 'code' | 'board' | 'arena' | 'tools' | 'console')[];
  readonly language?: Language;
  readonly theme?: 'system' | 'light' | 'dark';
  /** How long the page may take to answer, in ms. Default 30,000. */
  readonly timeoutMs?: number;
  /** Receives the next piece of the program's output; lines end in `\n`. */
  readonly onOutput?: (text: string) => void;
  /** Receives the traceback that ended the program, or one sentence about what failed. */
  readonly onError?: (text: string) => void;
  readonly onState?: (state: DeviceState) => void;
  /** Saves an exported project; by default the browser downloads it. */
  readonly saveFile?: (name: string, text: string) => void;
}

/** The simulator as a device: it runs, stops and exports programs. Nothing is flashed, so there is no such function. */
export interface ParcoursDevice extends DeviceInterface {
  /** Shows the simulator and connects with it; a second call does nothing. */
  registerDevice(): void;
  /** Ends the run and the connection, and removes a frame of the device's own. */
  disconnectDevice(): void;
  /** Ends the run and puts everything back to the start. */
  cleanUp(): void;
  /** Runs this as `main.py`; registers the device first if necessary. */
  runCode(code: string): void;
  stopCode(): void;
  /** Saves this program with its course and robot as a file that Parcours opens. */
  exportCode(code: string): void;
}

/** Name of an exported file. */
const EXPORT_NAME = 'main.parcours.json';

/** The parts of the page for a host with an editor and a console of its own. */
const PARTS = ['board', 'arena'] as const;

/**
 * Makes the device. Its functions return at once and take effect in order; `onError` reports errors.
 *
 * @throws TypeError if there is neither a frame nor a container with an address
 */
export function createParcoursDevice(options: ParcoursDeviceOptions): ParcoursDevice {
  if (options.frame === undefined && (options.container === undefined || options.address === undefined))
    throw new TypeError('A Parcours device needs a frame, or a container and an address.');
  const link = new DeviceLink(options);
  return {
    registerDevice: () => link.open(),
    disconnectDevice: () => link.close(),
    cleanUp: () => link.end((parcours) => parcours.reset()),
    runCode(code) {
      link.open();
      link.run(code);
    },
    stopCode: () => link.end((parcours) => parcours.stop()),
    exportCode(code) {
      link.open();
      link.whenOpen(async (parcours) => {
        const project = await parcours.getProject();
        const files = [{ name: 'main.py', text: code }];
        (options.saveFile ?? download)(EXPORT_NAME, JSON.stringify({ ...project, files }, null, 2));
      });
    },
  };
}

/** The connection with the page, and the actions that wait for it. */
class DeviceLink {
  private state: DeviceState = 'absent';
  private own: HTMLIFrameElement | null = null;
  /** Resolves to `null` if the page does not answer. */
  private connected: Promise<Parcours | null> | null = null;
  private last: Promise<void> = Promise.resolve();
  private readonly printing = new Printing((text) => this.options.onOutput?.(text));

  constructor(private readonly options: ParcoursDeviceOptions) {}

  open(): void {
    if (this.connected !== null && this.state !== 'missing') return;
    this.tell('connecting');
    const target = this.options.frame ?? this.show();
    const connected: Promise<Parcours | null> = connect(target, this.connectOptions()).then(
      async (parcours) => {
        if (this.connected !== connected) {
          parcours.close();
          return null;
        }
        this.listen(parcours, () => this.connected === connected);
        await this.setUp(parcours);
        if (this.connected === connected) this.tell('ready');
        return parcours;
      },
      (error: unknown) => {
        if (this.connected === connected) {
          this.tell('missing');
          this.complain(error);
        }
        return null;
      },
    );
    this.connected = connected;
    this.last = Promise.resolve();
  }

  /** Does something once the page is ready and earlier requests are done. */
  whenOpen(act: (parcours: Parcours) => Promise<void>): void {
    const { connected } = this;
    if (connected === null) return;
    this.last = this.last.then(async () => {
      const parcours = await connected;
      if (parcours === null || this.connected !== connected) return;
      await act(parcours).catch((error: unknown) => this.complain(error));
    });
  }

  /** Runs this as `main.py`. Later actions do not wait until it has begun, because the page may never get that far. */
  run(code: string): void {
    const { ends } = this;
    this.whenOpen(async (parcours) => {
      await parcours.setFiles([{ name: 'main.py', text: code }]);
      parcours.run().catch((error: unknown) => {
        if (ends === this.ends) this.complain(error);
      });
    });
  }

  /** Ends the current or coming run. If it had not begun yet, that is not an error. */
  end(act: (parcours: Parcours) => Promise<void>): void {
    this.ends += 1;
    this.whenOpen(act);
  }
  /** Number of requested ends. */
  private ends = 0;

  close(): void {
    const { connected, own } = this;
    if (connected === null) return;
    this.connected = null;
    this.own = null;
    this.printing.forget();
    own?.remove();
    void connected.then(async (parcours) => {
      // A frame of the host stays, with nothing running in it; our own is already gone.
      if (own === null) await parcours?.stop().catch(() => undefined);
      parcours?.close();
    });
    this.tell('absent');
  }

  private connectOptions() {
    const { timeoutMs } = this.options;
    return { client: 'WebTigerPython device', ...(timeoutMs === undefined ? {} : { timeoutMs }) };
  }

  private show(): HTMLIFrameElement {
    this.own?.remove();
    const { container, address = '', title = 'Parcours' } = this.options;
    const frame = document.createElement('iframe');
    const url = new URL(address, location.href);
    url.searchParams.set('dialect', 'none'); // our own dialect tells it everything
    frame.src = url.href;
    frame.title = title;
    frame.allow = 'autoplay; microphone';
    frame.style.cssText = 'border: 0; width: 100%; height: 100%; display: block';
    container?.append(frame);
    this.own = frame;
    return frame;
  }

  private async setUp(parcours: Parcours): Promise<void> {
    const { parts = PARTS, language, theme, board, robot } = this.options;
    try {
      await parcours.setSettings({ parts, ...(language && { language }), ...(theme && { theme }) });
      if (board !== undefined || robot !== undefined)
        await parcours.setRobot({
          ...(board !== undefined && { device: board }),
          ...(robot !== undefined && { robot }),
        });
    } catch (error) {
      this.complain(error);
    }
  }

  /** @param isOpen whether this connection is still the device's: its last messages come after the host has left */
  private listen(parcours: Parcours, isOpen: () => boolean): void {
    const on = <E extends keyof ClientEvents>(event: E, act: (data: ClientEvents[E]) => void): void =>
      void parcours.on(event, (data) => {
        if (isOpen()) act(data);
      });
    on('started', () => this.begin());
    on('program-restarted', () => this.begin());
    on('output', ({ text }) => this.print(parcours, text));
    on('ended', (ended) => this.finish(ended));
    on('failed', ({ message }) => this.options.onError?.(message));
    on('phase', ({ phase }) => {
      if (phase === 'running' || phase === 'paused') this.tell('running');
      if (['ready', 'stopped', 'killed', 'failed'].includes(phase)) {
        this.finish(null);
        this.tell('ready');
      }
    });
    on('restarted', () => {
      this.finish(null);
      void this.setUp(parcours).then(() => isOpen() && this.tell('ready'));
    });
  }

  private begin(): void {
    this.finish(null);
    this.printing.begin();
    this.tell('running');
  }

  /** The program is over; later output of the REPL does not concern the host. */
  private finish(ended: Events['ended'] | null): void {
    const traceback = ended?.exception?.traceback ?? null;
    const printed = this.printing.end({ traceback, isStopped: ended?.ended === 'stopped' });
    if (printed === null) return;
    if (ended !== null) this.tell('ended');
    if (printed.error !== null) this.options.onError?.(printed.error);
  }

  private print(parcours: Parcours, text: string): void {
    if (!this.printing.isLive) return;
    this.printing.add(text);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      void parcours.getState().then(
        ({ snapshot }) => {
          // While only the world goes on, the program is over and its end is on the way.
          if (snapshot?.running !== 'world') this.printing.release();
        },
        () => undefined, // the page is gone
      );
    }, HOLD_MS);
  }
  private timer: ReturnType<typeof setTimeout> | undefined;

  private tell(state: DeviceState): void {
    if (state === this.state) return;
    this.state = state;
    this.options.onState?.(state);
  }

  private complain(error: unknown): void {
    if (error instanceof ParcoursError && error.code === 'closed') return;
    this.options.onError?.(error instanceof Error ? error.message : String(error));
  }
}

function download(name: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type: 'application/json' }));
  const anchor = Object.assign(document.createElement('a'), { href: address, download: name });
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000); // chosen: every browser has begun to save by then
}
