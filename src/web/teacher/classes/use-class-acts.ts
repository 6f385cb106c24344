import { textOf } from '#intake/file';
import { classToText, parseClass } from '#school-class/class-file';
import { namesIn } from '#school-class/class-list';
import { mergeClasses } from '#school-class/merge';
import { rowsOf } from '#school-class/progress';
import { classReport } from '#school-class/report/html';
import { classTable } from '#school-class/report/table';
import { classLimits, type SchoolClass } from '#school-class/school-class';

import type { AddedFile } from '../../kit/files/added-files';
import { shownLanguage, t } from '../../kit/i18n';
import { spreadsheetForm } from '../../kit/i18n/spreadsheet-form';
import type { PageParts } from '../../kit/parts';
import { fileName, saveText } from '../../session/work/save-file';
import type { ClassBook } from '../class-book/class-book';
import { today } from '../class-book/use-class-book';
import words from './words';

/** The acts on the class in sight, and taking files. */
export interface ClassActs {
  readonly saveFile: () => void;
  readonly saveTable: () => void;
  /** The report as a page of HTML. */
  readonly report: () => string;
  /** Takes files of classes and lists of names. */
  readonly take: (files: readonly AddedFile[]) => Promise<void>;
  readonly remove: () => void;
}

/** @param begin begins a class with a list of names, one a line */
export function useClassActs(
  { notices }: Pick<PageParts, 'notices'>,
  book: ClassBook,
  begin: (names: string) => void,
): ClassActs {
  const withClass = (act: (schoolClass: SchoolClass) => void): void => {
    const { schoolClass } = book.chosen.value ?? {};
    if (schoolClass !== undefined) act(schoolClass);
  };
  const save = (name: string, ending: string, text: string, type: string): void => {
    saveText({ notices }, fileName(name, ending), text, type);
  };
  return {
    saveFile() {
      withClass((schoolClass) => {
        save(schoolClass.name, 'json', classToText(schoolClass), 'application/json');
        book.noteSaved();
      });
    },
    saveTable() {
      withClass((schoolClass) => {
        const rows = rowsOf(schoolClass, today());
        const language = shownLanguage();
        const text = classTable(schoolClass, rows, language, spreadsheetForm(language));
        save(schoolClass.name, 'csv', text, 'text/csv');
      });
    },
    report() {
      const { schoolClass } = book.chosen.value ?? {};
      return schoolClass === undefined ? '' : classReport(schoolClass, today(), shownLanguage());
    },
    async take(files) {
      for (const file of files) {
        const problem = await takeOne(file, { notices, book, begin });
        const values = { text: t(words.refused, { file: file.path, reason: problem ?? '' }) };
        if (problem !== null) notices.show({ kind: 'error', key: 'notice.text', values });
      }
    },
    remove() {
      withClass(({ name }) => offerUndo({ notices, book }, t(words.removed, { name }), book.remove()));
    },
  };
}

interface Taking {
  readonly notices: PageParts['notices'];
  readonly book: ClassBook;
  readonly begin: (names: string) => void;
}

/** Tells of a change that was made, with a button that takes it back as long as nothing else is changed. */
export function offerUndo({ notices, book }: Pick<Taking, 'notices' | 'book'>, text: string, undo: () => void): void {
  const now = book.classes.value.map(({ schoolClass }) => schoolClass);
  notices.show({
    ...{ kind: 'ok', key: 'notice.text', values: { text }, action: { key: 'notice.undo', run: undo }, stays: true },
    holds: () =>
      book.classes.value.length === now.length &&
      book.classes.value.every(({ schoolClass }, place) => schoolClass === now[place]),
  });
}

/** Takes a file: a class, or a list of names. @returns the reason why it cannot be, in words; `null`: it was taken */
async function takeOne({ file }: AddedFile, taking: Taking): Promise<string | null> {
  if (file.size > classLimits.characters) return t(words.tooLarge);
  const text = textOf(new Uint8Array(await file.arrayBuffer()));
  if (text === null) return t(words.noText);
  if (/^\ufeff?\s*\{/.test(text)) {
    const parsed = parseClass(text);
    if ('problem' in parsed) return parsed.problem;
    open(parsed.schoolClass, taking);
    return null;
  }
  const names = namesIn(text);
  if (names.length === 0) return t(words.noNames);
  taking.begin(names.join('\n'));
  return null;
}

/** Opens a class; a copy of one that is open is joined with it. */
function open(schoolClass: SchoolClass, { notices, book }: Taking): void {
  const same = book.classes.value.find((one) => one.schoolClass.name === schoolClass.name);
  if (same === undefined) {
    book.add(schoolClass, true);
    return;
  }
  book.choose(same.key);
  const undo = book.change((now) => mergeClasses(now, schoolClass));
  offerUndo({ notices, book }, t(words.joined, { name: schoolClass.name }), undo);
}
