import { t } from '.';

export { t as say };
