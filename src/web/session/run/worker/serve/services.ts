/** The services of a worker. Each is loaded when it is opened: no run needs their code. */
import { taskReadBefore } from '#check/task/read-task';

import type { Opening, ServiceName, Services } from './protocol';

/** A service's means: the compiled VM, and a sign of life with the place of the world that runs. */
export interface Means {
  readonly firmware: WebAssembly.Module;
  readonly beat: (world: number) => void;
}

/** Answers one request. */
export type Serve<Name extends ServiceName> = (request: Services[Name]['request']) => Promise<Services[Name]['result']>;

/** A part of the worker did not come. */
export class Unloaded extends Error {}

/** A part that is being fetched. Throws Unloaded if it does not come. */
const part = <T>(coming: Promise<T>): Promise<T> =>
  coming.catch((error: unknown) => {
    throw new Unloaded(String(error));
  });

type Open<Name extends ServiceName> = (open: Services[Name]['open'], means: Means) => Promise<Serve<Name>>;

const services: { readonly [Name in ServiceName]: Open<Name> } = {
  async check({ task: project, starts }, means) {
    const { check } = await part(import('#check/check'));
    const task = taskReadBefore(project);
    return ({ handIn, lost }) => check(task, handIn, { ...means, starts, ...(lost !== undefined && { lost }) });
  },
  async runs(_, { firmware, beat }) {
    const { answerRun } = await part(import('#lab/run-request'));
    return (request) => answerRun(request, { firmware, beat: () => beat(0) });
  },
  async hint({ task: project }, { firmware, beat }) {
    const { hintFor } = await part(import('#hint/hint'));
    const task = taskReadBefore(project);
    return ({ handIn, budget }) => hintFor(task, handIn, { firmware, budget, beat });
  },
  async facts({ task: project }, { firmware, beat }) {
    const { factsOf } = await part(import('#hint/groups/run-facts'));
    const task = taskReadBefore(project);
    return ({ handIn, result }) => factsOf(task, handIn, result, { firmware, beat: () => beat(0) });
  },
  async 'group-hint'({ task: project }, { firmware, beat }) {
    const { groupHint } = await part(import('#hint/groups/group-hint'));
    const task = taskReadBefore(project);
    return ({ handIns, budget }) => groupHint(task, handIns, { firmware, budget, beat: () => beat(0) });
  },
};

/** Opens a service. */
export function openService(opening: Opening, means: Means): Promise<(request: unknown) => Promise<unknown>> {
  // Requests of one service come with its opening: the page's types say so (`serveThread`).
  const open = services[opening.service] as (
    open: Opening,
    means: Means,
  ) => Promise<(request: unknown) => Promise<unknown>>;
  return open(opening, means);
}
