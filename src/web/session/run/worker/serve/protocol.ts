/**
 * The messages between the page and a worker that serves it beside the run: the page opens one service, and then asks one
 * thing after the other. One worker has one service.
 */
import type { HandIn } from '#check/hand-in/hand-in';
import type { Answer, CheckRequest } from '#check/lane';
import type { CheckResult } from '#check/result';
import type { GroupHint } from '#hint/groups/group-hint';
import type { RunFacts } from '#hint/groups/run-facts';
import type { Hint } from '#hint/hint';
import type { HintRequest } from '#hint/hint-lane';
import type { RunAnswer, RunRequest } from '#lab/run-request';
import type { Project } from '#project/project';

/** The services: each with the data that it is opened with, a request, and its result. */
export interface Services {
  /** Checks hand-ins of a task. `starts`: its start program in other languages. */
  readonly check: {
    readonly open: { readonly task: Project; readonly starts: readonly string[] };
    readonly request: CheckRequest;
    readonly result: CheckResult;
  };
  /** Makes runs. */
  readonly runs: { readonly open: object; readonly request: RunRequest; readonly result: RunAnswer };
  /** Finds hints to programs for a task; the result is `null` if the program passes. */
  readonly hint: {
    readonly open: { readonly task: Project };
    readonly request: HintRequest;
    readonly result: Hint | null;
  };
  /** Says what the run of a checked hand-in did; the result is `null` if there is nothing to say. */
  readonly facts: {
    readonly open: { readonly task: Project };
    readonly request: { readonly handIn: HandIn; readonly result: CheckResult };
    readonly result: RunFacts | null;
  };
  /** Finds the hint to a group of hand-ins, its example first; the result is `null` if that passes. */
  readonly 'group-hint': {
    readonly open: { readonly task: Project };
    readonly request: { readonly handIns: readonly HandIn[]; readonly budget: number };
    readonly result: GroupHint | null;
  };
}

export type ServiceName = keyof Services;

/** A service and the data that it is opened with. */
export type Opening = {
  readonly [Name in ServiceName]: { readonly service: Name } & Services[Name]['open'];
}[ServiceName];

/** From the page. */
export type ToServer =
  | { readonly type: 'serve-open'; readonly opening: Opening; readonly firmware: WebAssembly.Module }
  | { readonly type: 'serve'; readonly request: unknown };

/** To the page. */
export type FromServer =
  | { readonly type: 'served'; readonly answer: Answer<unknown> }
  /** Time passes, in the world of this place. */
  | { readonly type: 'serve-beat'; readonly world: number };
