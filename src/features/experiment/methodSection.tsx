import { MathSymbol } from '../../charts/textView.tsx';
import { DEFAULTS } from '../../core/scenario/defaults.ts';
import type { EngineId, MethodOptions, ScenarioFile } from '../../core/scenario/types.ts';
import { edit, useUi } from '../../ui/context.ts';
import { Check, Choice, Section } from '../../ui/kit/controls.tsx';
import { withMethod } from '../../app/state/draft.ts';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { words } from './words.ts';
import type { NumberSpec } from '../../ui/kit/useNumberField.ts';

const methodDefaults = {
  name: DEFAULTS.method,
  formulation: DEFAULTS.formulation,
  rtol: DEFAULTS.rtol,
  atol: DEFAULTS.atol,
  projection: true,
} as const;

/** The method without a formulation, and what its choice then says. */
const RESIDUAL_METHOD = 'ida';
const NONE = '';
/** No choice of an engine. */
const FASTEST = '';

/** Another method; a formulation goes where it has no meaning. */
function named(draft: ScenarioFile, id: string): ScenarioFile {
  const next = withMethod(draft, 'name', id === methodDefaults.name ? undefined : id);
  return id === RESIDUAL_METHOD ? withMethod(next, 'formulation', undefined) : next;
}

export function MethodSection() {
  const ui = useUi();
  const method: Partial<MethodOptions> = ui.app.state.draft.value.method ?? {};
  const base = ui.origin.value?.scenario.method;
  const errors = ui.app.state.draftErrors.value;
  const name = method.name ?? methodDefaults.name;
  const residual = name === RESIDUAL_METHOD;
  const adaptive = ui.methods.find((m) => m.id === name)?.adaptive !== false;
  const set = <K extends keyof MethodOptions>(key: K, value: MethodOptions[K] | undefined) =>
    edit(ui, words.method, (draft) =>
      withMethod(draft, key, value === (methodDefaults as Partial<MethodOptions>)[key] ? undefined : value),
    );
  const spec = (key: 'rtol' | 'atol' | 'step' | 'maxStep', standard?: number): NumberSpec => ({
    path: `method.${key}`,
    label: words[key],
    angle: false,
    numeric: true,
    positive: true,
    unit: key === 'step' || key === 'maxStep' ? 's' : '',
    max: key === 'rtol' ? 1 : undefined,
    optional: true,
    value: method[key] ?? standard,
    base: base?.[key] ?? standard,
    rest: standard,
    step: standard ? standard : 0.001,
    commit: (value) => set(key, value as number | undefined),
  });
  return (
    <Section title={words.method}>
      <Choice
        label={words.method}
        value={name}
        options={ui.methods}
        error={errors.get('method.name')}
        testId="method-name"
        onChange={(id) => edit(ui, words.method, (draft) => named(draft, id))}
      />
      <Choice
        label={words.formulation}
        value={method.formulation ?? (residual ? NONE : methodDefaults.formulation)}
        options={residual ? [{ id: NONE, label: words.residualAsItIs }] : ui.formulations}
        disabled={residual && method.formulation === undefined}
        error={errors.get('method.formulation')}
        testId="method-formulation"
        onChange={(id) => set('formulation', id === NONE ? undefined : id)}
      />
      {adaptive && (
        <NumberField symbol={<MathSymbol of="rtol" />} spec={spec('rtol', methodDefaults.rtol)} testId="method-rtol" />
      )}
      {adaptive && (
        <NumberField symbol={<MathSymbol of="atol" />} spec={spec('atol', methodDefaults.atol)} testId="method-atol" />
      )}
      <NumberField symbol={<MathSymbol of="h" />} spec={spec('step')} placeholder={words.auto} testId="method-step" />
      {adaptive && (
        <NumberField
          symbol={<MathSymbol of="h_max" />}
          spec={spec('maxStep')}
          placeholder={words.auto}
          testId="method-maxStep"
        />
      )}
      <Choice
        label={words.engine}
        value={method.engine ?? FASTEST}
        options={[
          { id: FASTEST, label: words.fastest },
          { id: 'wasm', label: 'WebAssembly' },
          { id: 'typescript', label: 'TypeScript' },
        ]}
        error={errors.get('method.engine')}
        testId="method-engine"
        onChange={(id) => set('engine', id === FASTEST ? undefined : (id as EngineId))}
      />
      <Check
        label={words.projection}
        checked={method.projection ?? true}
        testId="method-projection"
        onChange={(on) => set('projection', on)}
      />
    </Section>
  );
}
