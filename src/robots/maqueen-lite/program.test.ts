import { describeEffects } from '../testing/maqueen-effects';
import { maqueenLiteBuild } from './robot';

describeEffects({ build: maqueenLiteBuild, module: 'mbrobot', sonarMm: 55, ports: ['S1', 'S2'] });
