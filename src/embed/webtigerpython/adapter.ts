/**
 * WebTigerPython's dialect: the page says `pythonReady`, the host sends `files` and `run_code`, and receives the
 * program's output. A host may send everything at once and in any order: files that come before a `run_code` are those
 * that run.
 */
import * as v from 'valibot';

import { filesOfList, filesOfText } from '#project/webtigerpython/files-in-link';
import { deviceCalled } from '#project/webtigerpython/device-names';
import type { RunPhase } from '#simulation/pace';
import type { Ended } from '#simulation/simulation';

import type { Adapter, CreateAdapter, HostConnection } from '../adapter';
import { listenToFirst } from '../first-device';
import { PARTS, type EmbeddedSimulator, type HostSettings, type Part, type SimulatorEvent } from '../simulator';
import { hostMessage, type HostMessage, type PageMessage, type SettingsData } from './messages';
import { HOLD_MS, Printing } from './printing';
import { flagOf, languageOf, partsOfLayout, PICTURE } from './words';

/** Phases without a running program. */
const OVER: readonly RunPhase[] = ['ready', 'stopped', 'killed', 'failed'];

/** Makes the adapter; the page is then ready, and says so. */
export const createWebTigerPythonAdapter: CreateAdapter = (simulator, connection): Adapter => {
  let isOpen = true;
  const post = (message: PageMessage): void => {
    if (isOpen) connection.post(message);
  };
  const sender = new EventSender(simulator, connection, post);
  const unlisten = listenToFirst(simulator, (event) => sender.hear(event));
  post({ type: 'pythonReady', data: null });
  return {
    receive(message) {
      const read = isOpen ? judged(message) : null;
      if (read !== null) obey(read, simulator, sender);
    },
    close() {
      isOpen = false;
      unlisten();
    },
  };
};

/** The content of a message, if it is one of ours. */
function judged(message: unknown): HostMessage | null {
  try {
    const read = v.safeParse(hostMessage, message);
    return read.success ? read.output : null;
  } catch {
    return null; // only an object of this very page throws when it is read; it is not ours either
  }
}

function obey(message: HostMessage, simulator: EmbeddedSimulator, sender: EventSender): void {
  switch (message.type) {
    case 'files':
      return bring(message.data, simulator, sender);
    case 'settings':
      for (const settings of settingsOf(message.data, simulator.settings().parts)) simulator.change(settings);
      if (message.data.code !== undefined) bring(message.data.code, simulator, sender);
      return;
    case 'run_code':
      sender.run();
      return;
    default:
      message satisfies never;
  }
}

function bring(
  program: Extract<HostMessage, { type: 'files' }>['data'],
  simulator: EmbeddedSimulator,
  sender: EventSender,
): void {
  const files = typeof program === 'string' ? filesOfText(program) : filesOfList([program].flat());
  const problem = files === null ? 'There is no program in it.' : simulator.setFiles(files);
  if (problem !== null) sender.complain(problem);
}

/** The settings of a message, field by field: one that is refused does not affect the others. */
function settingsOf(data: SettingsData, shown: readonly Part[]): readonly HostSettings[] {
  const language = languageOf(data.lang ?? '');
  const isDark = flagOf(data.dark_mode);
  const device = data.device === undefined ? null : (deviceCalled(data.device) ?? data.device);
  const parts = partsOf(data, shown);
  return [
    ...(language === undefined ? [] : [{ language }]),
    ...(isDark === undefined ? [] : [{ theme: isDark ? ('dark' as const) : ('light' as const) }]),
    ...(device === null ? [] : [{ device }]),
    ...(parts === null ? [] : [{ parts }]),
  ];
}

/** The parts to show from now on; `null`: as before. */
function partsOf(data: SettingsData, shown: readonly Part[]): readonly Part[] | null {
  const layout = partsOfLayout(data.layout);
  const isBare = flagOf(data.hide_topbar);
  const isFull = flagOf(data.full_screen);
  const asked = layout ?? (isFull === true ? PICTURE : isFull === false ? PARTS : null);
  if (isBare === true || isFull === true) return (asked ?? shown).filter((part) => part !== 'bar');
  if (isBare === false) return PARTS.filter((part) => part === 'bar' || (asked ?? shown).includes(part));
  return asked;
}

/** Sends the host the output of the run, and when it begins and ends. */
class EventSender {
  private readonly printing = new Printing((data) => this.post({ type: 'output', data }));
  private heldSinceMs = 0;
  private complaints = 0;

  constructor(
    private readonly simulator: EmbeddedSimulator,
    private readonly connection: HostConnection,
    private readonly post: (message: PageMessage) => void,
  ) {}

  run(): void {
    const before = this.complaints;
    void this.simulator.run().then((problem) => {
      // A run that was stopped before it began has not failed: whoever stopped it knows.
      const isBroken = ['failed', 'killed'].includes(this.simulator.phase());
      if (problem !== null && isBroken && before === this.complaints) this.complain(problem);
    });
  }

  complain(problem: string): void {
    this.complaints += 1;
    this.post({ type: 'error', data: problem });
  }

  hear(event: SimulatorEvent): void {
    switch (event.type) {
      case 'started':
        this.end(null);
        this.post({
          type: 'code',
          data: this.simulator.project().files.map(({ name, text }) => ({ name, data: text })),
        });
        this.printing.begin();
        return;
      case 'program-restarted':
        this.printing.begin();
        return;
      case 'output':
        this.heldSinceMs = this.connection.nowMs();
        this.printing.add(event.text);
        return;
      case 'snapshot':
        // While only the world goes on, the program is over and its end is on the way.
        if (event.snapshot.running === 'program' && this.connection.nowMs() - this.heldSinceMs > HOLD_MS)
          this.printing.release();
        return;
      case 'program-ended':
        this.end(event.ended);
        return;
      case 'failed':
        this.complain(event.message);
        return;
      case 'phase':
        if (OVER.includes(event.phase)) this.end(null);
        return;
      case 'files':
      case 'scene':
      case 'settings':
      case 'sensed':
      case 'refused':
      case 'radio':
      case 'log':
      case 'held':
      case 'looking':
      case 'break-points':
        return; // WebTigerPython has no word for it
      default:
        event satisfies never;
    }
  }

  /**
   * The program is over: sends the rest of its output, the exception (unless Stop was pressed), then all output again.
   */
  private end(ended: Ended | null): void {
    const traceback = ended?.exception?.traceback ?? null;
    const printed = this.printing.end({ traceback, isStopped: ended?.kind === 'stopped' });
    if (printed === null) return;
    if (printed.error !== null) this.complain(printed.error);
    this.post({ type: 'full_output', data: printed.whole });
    this.post({ type: 'program_finished', data: null });
  }
}
