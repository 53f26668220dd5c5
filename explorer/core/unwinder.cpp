// What exceptions of WebAssembly need with libc++abi's cxa_exception.cpp and cxa_personality.cpp: the machine unwinds,
// and a landing pad asks the personality which handler is its own (as clang's WasmEHPrepare expects).

#include <unwind.h>

#include <cstdint>

struct LandingPad {
    std::uintptr_t index;     // of the landing pad, given
    std::uintptr_t table;     // its data, given
    std::uintptr_t selector;  // the handler, found
};

extern "C" {
LandingPad __wasm_lpad_context;
_Unwind_Reason_Code __gxx_personality_wasm0(int, _Unwind_Action, std::uint64_t, _Unwind_Exception*, _Unwind_Context*);

_Unwind_Reason_Code _Unwind_CallPersonality(void* thrown) {
    auto* exception = static_cast<_Unwind_Exception*>(thrown);
    __wasm_lpad_context.selector = 0;
    return __gxx_personality_wasm0(1, _UA_CLEANUP_PHASE, exception->exception_class, exception,
                                   reinterpret_cast<_Unwind_Context*>(&__wasm_lpad_context));
}
_Unwind_Reason_Code _Unwind_RaiseException(_Unwind_Exception* exception) {
    __builtin_wasm_throw(0, exception);
}
void _Unwind_DeleteException(_Unwind_Exception* exception) {
    if (exception->exception_cleanup) exception->exception_cleanup(_URC_FOREIGN_EXCEPTION_CAUGHT, exception);
}
void _Unwind_SetGR(_Unwind_Context* context, int index, _Unwind_Word value) {
    if (index == 1) reinterpret_cast<LandingPad*>(context)->selector = value;
}
_Unwind_Word _Unwind_GetIP(_Unwind_Context* context) {
    return reinterpret_cast<LandingPad*>(context)->index + 2;
}
void* _Unwind_GetLanguageSpecificData(_Unwind_Context* context) {
    return reinterpret_cast<void*>(reinterpret_cast<LandingPad*>(context)->table);
}
_Unwind_Ptr _Unwind_GetRegionStart(_Unwind_Context*) {
    return 0;
}
void _Unwind_SetIP(_Unwind_Context*, _Unwind_Word) {}
}
