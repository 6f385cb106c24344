import { strToU8, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { projectToText } from '#project/file';
import { defaultScene } from '#scene/scene';
import { handInOfBytes } from './contents';

const none = () => null;

describe('a file that is handed in', () => {
  it('is told to be no program where it is a picture, not to be no text', async () => {
    const picture = Uint8Array.of(0xff, 0xd8, 0xff, 0xe0, 0x00, 0x10, 0x4a, 0x46);
    expect(await handInOfBytes('Foto.jpg', picture, none)).toMatchObject({ problem: { code: 'kind' } });
    expect(await handInOfBytes('anna.py', picture, none)).toMatchObject({ problem: { code: 'not-text' } });
  });

  it('may be a program from an editor of Windows, with its mark at the beginning', async () => {
    const content = await handInOfBytes('anna.py', new TextEncoder().encode('\ufeffx = 1\r\n'), none);
    expect(content).toMatchObject({ handIn: { project: { files: [{ name: 'main.py', text: 'x = 1\r\n' }] } } });
  });

  it('may be a zip of a folder, in a folder, with what computers of Apple add', async () => {
    const zip = zipSync({
      'work/': new Uint8Array(),
      'work/anna/main.py': strToU8('import two\n'),
      'work/anna/two.py': strToU8('x = 2\n'),
      '__MACOSX/work/._anna': new Uint8Array(9),
    });
    const files = [{ name: 'main.py', text: 'import two\n' }, { name: 'two.py', text: 'x = 2\n' }]; // prettier-ignore
    expect(await handInOfBytes('anna.zip', zip, none)).toMatchObject({ handIn: { project: { files } } });
  });

  it('is found in however many folders', async () => {
    const zip = zipSync({ [`${'a/'.repeat(30_000)}main.py`]: strToU8('x = 1\n') });
    expect(await handInOfBytes('deep.zip', zip, none)).toHaveProperty('handIn');
  });

  it('asks for a newer Parcours if it is of a newer version, but not if it is damaged', async () => {
    const contentWith = (version: unknown) => {
      const project = { files: [{ name: 'main.py', text: '' }], scene: defaultScene(), course: null };
      const text = projectToText({ ...project, handIn: { version } });
      return handInOfBytes('anna.parcours.json', new TextEncoder().encode(text), () => null);
    };
    expect(await contentWith(9)).toMatchObject({ problem: { code: 'newer' } });
    expect(await contentWith('x')).toMatchObject({ problem: { code: 'project' } });
  });
});
