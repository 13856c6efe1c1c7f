/** The sections that are folded when the page opens: their code comes after what is seen. */
import { ControlSection, InputsSection } from './inputsSection.tsx';
import { MethodSection } from './methodSection.tsx';
import { ParametersSection } from './parametersSection.tsx';

export function LowerSections() {
  return (
    <>
      <ParametersSection />
      <MethodSection />
      <InputsSection />
      <ControlSection />
    </>
  );
}
