# Fails when a generated parser needs more than the next token somewhere: then it predicts, which costs time that grows with
# the input and finds errors late. Called with -D PARSER=file.
file(STRINGS ${PARSER} predictions REGEX "adaptivePredict")
if(predictions)
    file(REMOVE ${PARSER})
    message(FATAL_ERROR "the grammar is not LL(1): ${predictions}")
endif()
