/** Classes for tests. */
import { fileSource, type Source } from '#intake/sources';
import type { CheckRequest, StartThread } from '#check/lane';
import { unreadable } from '#check/result';

import { ClassModel, type ClassPorts } from '../class-model';

/** A program that somebody hands in. */
export const program = (name: string, text: string): Source =>
  fileSource(
    { path: `${name}.py`, size: text.length, read: () => ({ bytes: new TextEncoder().encode(text) }) },
    () => null,
  );

/** A class whose threads answer at once: whoever writes `forward` passes. */
export function classWith(more: Partial<ClassPorts> = {}) {
  const asked: string[] = [];
  const start: StartThread = (heard) => ({
    ask({ handIn }: CheckRequest) {
      const text = handIn.project.files[0]?.text ?? '';
      asked.push(text);
      const result = {
        ...unreadable([], { code: 'zip', params: {} }),
        passed: text.includes('forward'),
        remarks: [],
        twin: text,
      };
      queueMicrotask(() => heard({ result }));
    },
    pulse: () => ({ beat: 0, world: 0 }),
    stop: () => undefined,
  });
  const model = new ClassModel({ starter: () => Promise.resolve(start), every: () => () => undefined, lanes: 2, language: () => 'de', ...more }); // prettier-ignore
  const passed = () => model.rows.value.map(({ name, result }) => [name, result?.passed ?? null]);
  return { model, asked, passed };
}
