/**
 * The simulator as a device of WebTigerPython, or of any page with the same device interface: what the device's buttons
 * do there happens in a frame with Parcours.
 */
import { Printed } from '../webtigerpython/printed';
import { connect } from './connect';
import { ParcoursError } from './parcours-error';
import type { Events, Parcours } from './types';

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
  readonly language?: 'de' | 'fr' | 'it' | 'en';
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

/** How long what looks like the last traceback is held back while the program goes on, in ms. Chosen: its end is told long before, also on a busy machine. */
const HOLD_MS = 1000;

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
    cleanUp: () => link.whenOpen((parcours) => parcours.reset()),
    runCode(code) {
      link.open();
      link.whenOpen(async (parcours) => {
        await parcours.setFiles([{ name: 'main.py', text: code }]);
        await parcours.run();
      });
    },
    stopCode: () => link.whenOpen((parcours) => parcours.stop()),
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
  private printed: Printed | null = null;

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
        this.listen(parcours);
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

  close(): void {
    const { connected, own } = this;
    if (connected === null) return;
    this.connected = null;
    this.own = null;
    this.printed = null;
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

  private listen(parcours: Parcours): void {
    parcours.on('started', () => this.begin());
    parcours.on('program-restarted', () => this.begin());
    parcours.on('output', ({ text }) => this.print(parcours, text));
    parcours.on('ended', (ended) => this.end(ended));
    parcours.on('failed', ({ message }) => this.options.onError?.(message));
    parcours.on('phase', ({ phase }) => {
      if (phase === 'running' || phase === 'paused') this.tell('running');
      if (['ready', 'stopped', 'killed', 'failed'].includes(phase)) {
        this.end(null);
        this.tell('ready');
      }
    });
    parcours.on('restarted', () => {
      this.end(null);
      void this.setUp(parcours).then(() => this.tell('ready'));
    });
  }

  private begin(): void {
    this.end(null);
    this.printed = new Printed();
    this.tell('running');
  }

  /** The program is over; what the REPL prints from now on is none of the host's business. */
  private end(ended: Events['ended'] | null): void {
    if (this.printed === null) return;
    const traceback = ended?.exception?.traceback ?? null;
    this.say(this.printed.end(traceback));
    this.printed = null;
    if (ended !== null) this.tell('ended');
    if (traceback !== null && ended?.ended !== 'stopped') this.options.onError?.(traceback.replaceAll('\r\n', '\n'));
  }

  private print(parcours: Parcours, text: string): void {
    const { printed } = this;
    if (printed === null) return;
    this.say(printed.add(text));
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      void parcours.getState().then(
        ({ snapshot }) => {
          // While only the world goes on, the program is over: its end is on the way.
          if (printed === this.printed && snapshot?.running !== 'world') this.say(printed.release());
        },
        () => undefined, // the page is gone
      );
    }, HOLD_MS);
  }
  private timer: ReturnType<typeof setTimeout> | undefined;

  private say(text: string): void {
    if (text !== '') this.options.onOutput?.(text);
  }

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
