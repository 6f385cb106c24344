import { connect } from '../client/connect';
import type { ClientEvents, ConnectOptions, Parcours } from '../client/types';

/** The page's events, and the names of their DOM events on the element. */
const EVENTS: Readonly<Record<keyof ClientEvents, string>> = {
  phase: 'phase',
  started: 'started',
  'program-restarted': 'programrestart',
  ended: 'ended',
  output: 'output',
  snapshot: 'snapshot',
  held: 'held',
  looking: 'looking',
  'break-points-changed': 'breakpointschange',
  'scene-changed': 'scenechange',
  'files-changed': 'fileschange',
  'settings-changed': 'settingschange',
  sensed: 'sensed',
  radio: 'radio',
  log: 'log',
  refused: 'refused',
  failed: 'failed',
  restarted: 'parcours-restarted',
};

/** How long a page may take to answer, in ms. Chosen: a whole class opens it over one slow line. */
const CONNECT_MS = 120_000;

/** How to make the frame. */
export interface FrameOptions {
  readonly address: string;
  /** Name for screen readers. */
  readonly title: string;
  /** The frame's permissions, as in the attribute of the same name. */
  readonly allow: string;
  readonly isSandboxed: boolean;
  readonly subscribe: NonNullable<ConnectOptions['subscribe']>;
  /** Receives every event under its DOM name. */
  readonly tell: (event: string, detail: unknown) => void;
}

/** A frame with Parcours and its connection, from its insertion until it is closed. */
export class PageFrame {
  readonly frame: HTMLIFrameElement;
  private parcours: Parcours | null = null;
  private isClosed = false;

  constructor(private readonly options: FrameOptions) {
    this.frame = document.createElement('iframe');
    this.frame.title = options.title;
    this.frame.allow = options.allow;
    this.frame.part.add('frame');
    if (options.isSandboxed) this.frame.setAttribute('sandbox', 'allow-scripts');
    this.frame.src = options.address;
  }

  /**
   * Connects with the page; the frame must be in the document.
   *
   * @returns `null` if the frame was closed meanwhile
   * @throws ParcoursError (as a rejection) if the page does not answer
   */
  async connect(): Promise<Parcours | null> {
    const { subscribe, tell } = this.options;
    try {
      const wish = { client: 'parcours-simulator', timeoutMs: CONNECT_MS, subscribe };
      this.parcours = await connect(this.frame, wish);
    } catch (error) {
      if (this.isClosed) return null;
      throw error;
    }
    const { parcours } = this;
    if (this.isClosed) {
      parcours.close();
      return null;
    }
    for (const name of Object.keys(EVENTS) as (keyof ClientEvents)[])
      parcours.on(name, (detail) => tell(EVENTS[name], detail));
    return parcours;
  }

  /** Ends the connection and removes the frame. */
  close(): void {
    this.isClosed = true;
    this.parcours?.close();
    this.frame.remove();
  }
}
