import { linkForWebTigerPython } from '#intake/link-for-webtigerpython';
import { projectToText } from '#project/file';
import { linkOf, type Omitted } from '#project/link/link';
import { MAIN, type Project } from '#project/project';
import { noteText } from '#project/webtigerpython/say';
import { defaultScene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import type { ConvertOptions, Form } from './convert-arguments';
import type { Made } from './made';
import { makeHexFile } from './make-hex-file';
import type { Input } from './read-input';

/** Makes a form of work, or says why there is none. */
export async function makeForm(
  input: Input,
  form: Form,
  options: ConvertOptions,
): Promise<Made | { readonly problem: string }> {
  const { files, scene } = input.work;
  switch (form) {
    case 'project':
      return { text: projectToText(projectOf(input)), notes: [] };
    case 'course':
      return scene === null
        ? { problem: 'has no course, only a program.' }
        : { text: serializeScene(scene), notes: [] };
    case 'program': {
      const [main, ...others] = files;
      if (main === undefined) return { problem: noProgram(input) };
      const names = others.map(({ name }) => name).join(', ');
      return { text: main.text, notes: others.length === 0 ? [] : [`Only ${MAIN} is in it, without ${names}.`] };
    }
    case 'files':
      return files.length === 0 ? { problem: noProgram(input) } : { text: '', files, notes: [] };
    case 'hex':
      return files.length === 0 ? { problem: noProgram(input) } : makeHexFile(input, options);
    case 'link':
      return madeLink(input);
    case 'webtigerpython': {
      const made = linkForWebTigerPython(input.work);
      if (made === null) return { problem: TOO_LONG };
      return { text: `${made.link}\n`, notes: made.notes.map((note) => noteText(note, 'en')) };
    }
  }
}

/** Why there is no program: a hex has said so in its notes. */
const noProgram = ({ kind, notes }: Input): string =>
  kind === 'hex' ? (notes[0] ?? 'has no program.') : 'has no program, only a course.';

const TOO_LONG = 'is too long for a link. Save it as a project.';

async function madeLink(input: Input): Promise<Made | { readonly problem: string }> {
  const { readyCourse } = await import('../ready-courses');
  const made = linkOf(projectOf(input), { courses: readyCourse, program: true });
  if (made === null) return { problem: TOO_LONG };
  return { text: `#${made.fragment}\n`, notes: made.omitted.map((part) => OMITTED[part]) };
}

const OMITTED: Readonly<Record<Omitted, string>> = {
  picture: 'The picture of the floor is left out; sensors see the floor all the same.',
  background: 'The picture on the floor is left out.',
  'task-picture': 'The picture of the task is left out.',
};

/** A course alone gets an empty program, a program alone an empty arena. */
const projectOf = ({ work, course }: Input): Project => ({
  ...work,
  files: work.files.length === 0 ? [{ name: MAIN, text: '' }] : work.files,
  scene: work.scene ?? defaultScene(),
  course,
});
