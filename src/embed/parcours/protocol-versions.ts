import type { CommandName, EventName } from './protocol';

/** A version of the app, and the commands and events that it brought. */
export interface ProtocolChange {
  readonly app: string;
  readonly commands: readonly CommandName[];
  readonly events: readonly EventName[];
}

/** Each version of the app that added to the dialect, oldest first. Every command and event is in exactly one. */
export const protocolChanges: readonly ProtocolChange[] = [
  {
    app: '0.1.0',
    commands: [
      'hello', 'bye', 'state', 'subscribe', 'get-project', 'set-project', 'get-files', 'set-files', 'get-scene', 'set-scene',
      'edit', 'get-robot', 'set-robot', 'get-settings', 'settings', 'run', 'stop', 'reset', 'pause', 'resume', 'step', 'speed',
      'seed', 'reality', 'place', 'place-block', 'press', 'touch', 'sensor', 'arena-senses', 'serial', 'interrupt', 'radio',
      'clear-console',
    ], // prettier-ignore
    events: [
      'phase', 'started', 'program-restarted', 'ended', 'output', 'snapshot', 'scene-changed', 'files-changed',
      'settings-changed', 'sensed', 'radio', 'log', 'refused', 'failed',
    ], // prettier-ignore
  },
  {
    app: '1.0.0',
    commands: [
      'get-break-points', 'set-break-points', 'get-position', 'step-line', 'run-to', 'look-at', 'look-now', 'go-on',
    ], // prettier-ignore
    events: ['held', 'looking', 'break-points-changed'],
  },
  { app: '1.1.0', commands: ['set-mode'], events: [] },
];

/** `since` for the manual: the version that brought a command or an event, unless it is the first. */
export function laterVersion(kind: 'commands' | 'events', name: CommandName | EventName): { readonly since?: string } {
  const change = protocolChanges.slice(1).find((one) => (one[kind] as readonly string[]).includes(name));
  return change ? { since: change.app } : {};
}
