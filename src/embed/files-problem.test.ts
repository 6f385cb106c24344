import { describe, expect, it } from 'vitest';

import { FILE_BYTES, MAIN, projectLimits } from '#project/project';

import { filesProblem } from './files-problem';
import { RecordingSimulator } from './testing/recording-simulator';
import { createWebTigerPythonAdapter } from './webtigerpython/adapter';

const main = { name: MAIN, text: '' };

describe('the files of a host', () => {
  it('are taken as they are when a project may have them', () => {
    expect(filesProblem([main, { name: 'drive.py', text: 'ü'.repeat(FILE_BYTES / 2) }])).toBeNull();
  });

  it.each([
    ['that are too many', Array.from({ length: projectLimits.files + 1 }, (_, at) => ({ name: at === 0 ? MAIN : `a${at}.py`, text: '' })), 'the limit is 20'], // prettier-ignore
    ['of which one is too long for a project file', [{ name: MAIN, text: 'ü'.repeat(FILE_BYTES / 2 + 1) }], 'files.0.text'], // prettier-ignore
    ['two of which have one name', [main, main], 'nameTaken'],
    ['with a name in another folder', [main, { name: '../a.py', text: '' }], 'files.1.name'],
    ['without a program', [{ name: 'drive.py', text: '' }], 'main.py is missing'],
  ])('%s are refused with the reason', (_, files, reason) => {
    expect(filesProblem(files)).toContain(reason);
  });

  it('are as limited where they come as one text', () => {
    const simulator = new RecordingSimulator();
    const said: object[] = [];
    const adapter = createWebTigerPythonAdapter(simulator, {
      nowMs: () => 0,
      post: (message) => void said.push(message),
    });
    const many = Array.from({ length: 5000 }, (_, at) => ({ name: `a${at}.py`, data: '' }));
    adapter.receive({ type: 'files', data: JSON.stringify(many) });
    expect(simulator.project().files).toHaveLength(1);
    expect(said.at(-1)).toMatchObject({ type: 'error' });
    adapter.close();
  });
});
