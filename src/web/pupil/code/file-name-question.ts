import { completeName, NAME_CHARACTERS, nameProblem } from '#project/project';

import type { Question } from '../../kit/dialogs';
import { t } from '../../kit/i18n';
import type { WorkParts } from '../../session/work/model/parts';

/**
 * Asks for a file's name that no other file of the program has.
 *
 * @param own the name it has now; `''` for a new file
 */
export const fileNameQuestion = (
  { work }: Pick<WorkParts, 'work'>,
  own: string,
  done: (name: string) => void,
): Question & { kind: 'name' } => ({
  kind: 'name',
  title: own === '' ? 'code.newTitle' : 'code.renameTitle',
  values: { file: own },
  field: () => ({
    id: 'file-name',
    mono: true,
    label: t('code.name'),
    own,
    complete: completeName,
    problem(name) {
      const found = nameProblem(name, work.files.value, own === '' ? undefined : own);
      return found === null ? null : t(`code.${found}`, { max: NAME_CHARACTERS });
    },
    placeholder: 'drive.py',
    submit: t(own === '' ? 'code.create' : 'code.rename'),
  }),
  done,
});
