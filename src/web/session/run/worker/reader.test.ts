// @vitest-environment happy-dom
import { zipSync, strToU8 } from 'fflate';
import { describe, expect, it } from 'vitest';

import { linkOf } from '#project/link/link';
import { defaultScene } from '#scene/scene';

import { Reader } from './reader';

const file = (name: string, content: BlobPart): File => new File([content], name);
const alone = (one: File) => ({ path: one.name, file: one });
async function contents(...added: readonly { readonly path: string; readonly file: File }[]) {
  const reader = new Reader();
  const opened = await reader.answer({ type: 'read-open', batch: 1, added, scenes: {} });
  if (opened.type !== 'read-names') throw new Error(opened.type);
  const found = [];
  for (const [place, name] of opened.names.entries()) {
    const answer = await reader.answer({ type: 'read', batch: 1, place });
    if (answer.type !== 'read-content') throw new Error(answer.type);
    const { content } = structuredClone(answer); // as it arrives at the page
    found.push([
      name,
      'handIn' in content ? content.handIn.project.files.map(({ text }) => text) : content.problem.code,
    ]);
  }
  return found;
}

describe('files that are handed in on the page', () => {
  it('are programs, and zips with a hand-in for each file and each folder', async () => {
    const zip = zipSync({ 'Ben.py': strToU8('b'), 'Cleo/main.py': strToU8('c'), 'Cleo/own.py': strToU8('o') });
    expect(await contents(alone(file('Ada.py', 'a')), alone(file('class.zip', zip as BlobPart)))).toEqual([
      ['Ada', ['a']],
      ['Ben', ['b']],
      ['Cleo', ['c', 'o']],
    ]);
  });

  it('are a folder as it was chosen or dropped: each of its folders is one hand-in', async () => {
    const inside = (path: string, text: string) => ({ path, file: file(path.split('/').at(-1)!, text) });
    const found = await contents(inside('7b/Ada/main.py', 'a'), inside('7b/Ben.py', 'b'), inside('7b/.DS_Store', 'x'));
    expect(found).toEqual([['Ada', ['a']], ['Ben', ['b']]]); // prettier-ignore
  });

  it('are texts with links in them, each with who stands before it', async () => {
    const made = linkOf({ files: [{ name: 'main.py', text: 'a' }], scene: defaultScene(), course: null }, { courses: () => null, program: true }); // prettier-ignore
    const text = `Liebe Frau B.,\nAda: https://example.org/#${made!.fragment}.\nBen: https://example.org/#p=2.AAAA`;
    const [ada, ben] = await contents(alone(file('mail.txt', text)));
    expect(ada).toEqual(['Ada', ['a']]);
    expect(ben).toEqual(['Ben', 'link']);
  });

  it('say so if they cannot be read, and keep nobody else from being read', async () => {
    expect(await contents(alone(file('Tim.zip', 'no zip')), alone(file('leer.txt', 'hallo')))).toEqual([
      ['Tim.zip', 'zip'],
      ['leer', 'no-link'],
    ]);
  });
});
