/**
 * The simulator as a device of WebTigerPython, or of any page with the same device interface: what the device's buttons
 * do there happens in a frame with Parcours.
 */
import type { Language } from '#core/texts';
import { HOLD_MS, Printing } from '../webtigerpython/printing';
import { connect } from './connect';
import { ParcoursError } from './parcours-error';
import type { ClientEvents, Events, Parcours } from './types';

/** A device as WebTigerPython knows it. Functions that a device does not have are greyed out there. */
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
 * Where the device stands. `absent`: not registered, or disconnected; `connecting`: its page loads; `ready`: nothing runs;
 * `ended`: the program is over, while a robot drives on and the REPL answers until Stop; `missing`: its page did not answer.
 */
export type DeviceState = 'absent' | 'connecting' | 'ready' | 'running' | 'ended' | 'missing';

/** What the device is, and whom it tells. */
export interface ParcoursDeviceOptions {
  /** The frame that shows Parcours, its window, or a port that leads to it. Instead of `container` and `address`. */
  readonly frame?: HTMLIFrameElement | Window | MessagePort;
  /** Where the device puts a frame of its own while it is registered. */
  readonly container?: HTMLElement;
  /** Address of Parcours for that frame. */
  readonly address?: string;
  /** What that frame is called for screen readers. At first `Parcours`. */
  readonly title?: string;
  /** Id of the microcomputer, such as `microbit-v2` or `calliope-mini-3`; at first as the program's imports say. */
  readonly board?: string;
  /** Id of the robot, `none` for the bare board; at first as the program's imports say. */
  readonly robot?: string;
  /** What is shown: `bar`, `code`, `board`, `arena`, `tools`, `console`. At first board and arena. */
  readonly parts?: readonly ('bar' | 'code' | 'board' | 'arena' | 'tools' | 'console')[];
  readonly language?: Language;
  readonly theme?: 'system' | 'light' | 'dark';
  /** How long the page may take to answer, in ms. At first 30,000. */
  readonly timeoutMs?: number;
  /** The next piece of what the program prints; lines end in `\n`. */
  readonly onOutput?: (text: string) => void;
  /** The traceback that ended the program, or in one sentence what could not be done. */
  readonly onError?: (text: string) => void;
  readonly onState?: (state: DeviceState) => void;
  /** Saves what is exported; at first the browser downloads it. */
  readonly saveFile?: (name: string, text: string) => void;
}

/** The simulator as a device: it runs, stops and exports programs. Nothing is flashed: there is no such function. */
export interface ParcoursDevice extends DeviceInterface {
  /** Shows the simulator and connects with it; twice is once. */
  registerDevice(): void;
  /** Ends the run and the connection; a frame of the device's own goes. */
  disconnectDevice(): void;
  /** Ends the run and puts everything back to the start. */
  cleanUp(): void;
  /** Runs this as `main.py`; a device that is not registered is registered first. */
  runCode(code: string): void;
  stopCode(): void;
  /** Saves this program with its course and robot as a file that Parcours opens. */
  exportCode(code: string): void;
}

/** Name of an exported file. */
const EXPORT_NAME = 'main.parcours.json';

/** The parts of the page that a host with an editor and a console of its own needs. */
const PARTS = ['board', 'arena'] as const;

/**
 * Makes the device. Its functions come back at once and do in their order what they are called for; what goes wrong is
 * told by `onError`.
 *
 * @throws TypeError when there is neither a frame nor a container with an address
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

/** The connection with the page, and what is waiting for it. */
class DeviceLink {
  private state: DeviceState = 'absent';
  private own: HTMLIFrameElement | null = null;
  /** Ends with `null` when the page does not answer. */
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

  /** Does something once the page is there and what was asked before is done. */
  whenOpen(act: (parcours: Parcours) => Promise<void>): void {
    const { connected } = this;
    if (connected === null) return;
    this.last = this.last.then(async () => {
      const parcours = await connected;
      if (parcours === null || this.connected !== connected) return;
      await act(parcours).catch((error: unknown) => this.complain(error));
    });
  }

  /** Runs this as `main.py`. What comes after need not wait until it has begun: the page may never come to that. */
  run(code: string): void {
    const { ends } = this;
    this.whenOpen(async (parcours) => {
      await parcours.setFiles([{ name: 'main.py', text: code }]);
      parcours.run().catch((error: unknown) => {
        if (ends === this.ends) this.complain(error);
      });
    });
  }

  /** Ends what runs or is about to: that it never began is no error then. */
  end(act: (parcours: Parcours) => Promise<void>): void {
    this.ends += 1;
    this.whenOpen(act);
  }
  /** How often an end was asked for. */
  private ends = 0;

  close(): void {
    const { connected, own } = this;
    if (connected === null) return;
    this.connected = null;
    this.own = null;
    this.printing.forget();
    own?.remove();
    void connected.then(async (parcours) => {
      // A frame that the host shows stays, with nothing running in it; our own is gone already.
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
    url.searchParams.set('dialect', 'none'); // it hears of everything by ours
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

  /** @param isOpen whether this connection is still the device's: its last words come after the host has left */
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

  /** The program is over; what the REPL prints from now on is none of the host's business. */
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
          // While only the world goes on, the program is over: its end is on the way.
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
